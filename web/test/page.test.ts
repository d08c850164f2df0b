// Tests texts, problems, shapes of tools, the path's columns: everything that needs no browser.
import { expect, test, vi } from "vitest";
import { en } from "../src/texts/en";
import { ru } from "../src/texts/ru";
import { PathIndex } from "../src/model/path_index";
import { new_tool, shape_of } from "../src/model/tool_shape";
import { box_of, proper, stock_of } from "../src/model/stock";
import { debounce, Latest } from "../src/model/latest";
import { read_frame, type PathFrame } from "../src/protocol/frames";
import { listed, listed_of_cut, of_shown_text } from "../src/model/listed";
import { grouped_problems } from "../src/ui/problems_panel";
import type { Finding, Problem, Tool } from "../src/protocol/types";
// @ts-expect-error plain JavaScript
import { path_frame } from "./mock-program.mjs";

const path_of = (frame: ArrayBuffer): PathFrame => read_frame(frame) as PathFrame;

test("both tables have the same keys, and the same places to fill in", () => {
  expect(Object.keys(ru)).toEqual(Object.keys(en));
  const holes = (s: string): string[] => (s.match(/\{\w+\}/g) ?? []).sort();
  for (const key of Object.keys(en) as (keyof typeof en)[]) {
    expect(holes(ru[key]), key).toEqual(holes(en[key]));
    expect(ru[key].trim(), key).not.toBe("");
  }
});

test("a frame of path: columns, bins, the block at an instant", () => {
  const { frame, seconds, blocks } = path_frame();
  expect(read_frame(frame.slice(0, 200))).toBeNull();
  expect(path_of(frame)).toMatchObject({
    kind: "path",
    which: 0,
    channel: 0,
    start: 0,
    least: [-20, -20, -15],
    greatest: [20, 20, 100],
  });
  const path = new PathIndex();
  path.add(path_of(frame));
  expect(path.seconds).toBeCloseTo(seconds, 3);
  expect(path.number_at(seconds)).toBe(blocks);
  expect(path.number_at(0)).toBe(6);
  const b = path.bins(0, seconds, 200);
  expect(Math.max(...b.greatest.filter((x) => !Number.isNaN(x)))).toBeGreaterThan(3000);
  for (let i = 0; i < 200; i++) if (!Number.isNaN(b.least[i]!)) expect(b.least[i]!).toBeLessThanOrEqual(b.greatest[i]!);
});

test("the strip shows the slowest and the fastest of every stretch, whole runs of vertices taken together or not", () => {
  const { frame, seconds } = path_frame(),
    c = path_of(frame),
    path = new PathIndex();
  path.add(c);
  for (const count of [1, 2, 7, 50, 400, 3000]) {
    const b = path.bins(0, seconds, count),
      width = seconds / count,
      least = Array(count).fill(Infinity),
      greatest = Array(count).fill(-Infinity);
    for (let i = 1; i < c.times.length; i++) {
      if (!(c.times[i]! > c.times[i - 1]!)) continue;
      for (
        let k = Math.floor(c.times[i - 1]! / width);
        k <= Math.min(count - 1, Math.floor(c.times[i]! / width));
        k++
      ) {
        least[k] = Math.min(least[k], c.speeds[i]!);
        greatest[k] = Math.max(greatest[k], c.speeds[i]!);
      }
    }
    for (let k = 0; k < count; k++)
      if (least[k] < Infinity) expect([b.least[k], b.greatest[k]], `${count}: ${k}`).toEqual([least[k], greatest[k]]);
  }
});

test("the other version's path is not the program's", () => {
  const path = new PathIndex();
  path.add(path_of(path_frame(0, 1).frame));
  expect([path.vertices, path.number_at(1)]).toEqual([0, 0]);
});

test("problems are grouped, alarms first", () => {
  const p = (id: string, severity: Problem["severity"], line: number): Problem => ({ id, severity, line, text: "" });
  const g = grouped_problems([p("a", "note", 1), p("b", "warning", 5), p("b", "warning", 6), p("c", "alarm", 9)]);
  expect(g.map((x) => [x.id, x.problems.length])).toEqual([
    ["c", 1],
    ["b", 2],
    ["a", 1],
  ]);
});

test("one list: of the run, of the text as it stands, of the cut", () => {
  const p = (id: string, line: number): Problem => ({ id, severity: "alarm", line, text: "" });
  const hit: Finding = { ...p("rapid_in_stock", 7), file: 0, at: 3, place: [0, 0, -4], depth: 8, tool: 1 };
  const ids = (of: Problem[]): string[] => of.map((x) => `${x.id} ${x.line}`);
  const run = {
    problems: [p("a", 1)],
    checked: null,
    findings: [hit],
    text: "as run",
    ran: "as run",
    cut_text: "as run",
  };
  expect(ids(listed(run))).toEqual(["a 1", "rapid_in_stock 7"]);
  expect(ids(of_shown_text(run))).toEqual(["a 1", "rapid_in_stock 7"]);
  expect(ids(listed({ ...run, checked: [p("a", 1), p("b", 2)] }))).toEqual(["a 1", "b 2", "rapid_in_stock 7"]);
  const edited = { ...run, checked: [p("b", 2)], text: "as typed" };
  expect(ids(listed(edited))).toEqual(["b 2", "rapid_in_stock 7"]);
  expect(ids(of_shown_text(edited))).toEqual(["b 2"]);
  expect(listed_of_cut(edited)).toEqual([hit]);
  const run_again = { ...edited, ran: "as typed" }; // the program follows its text: the cut does not
  expect(ids(listed(run_again))).toEqual(["a 1", "b 2", "rapid_in_stock 7"]);
  expect(ids(of_shown_text(run_again))).toEqual(["a 1", "b 2"]);
  expect(grouped_problems([hit, p("rapid_in_stock", 8)]).map((g) => g.problems.length)).toEqual([1, 1]);
});

test("shapes of tools", () => {
  expect(
    shape_of({
      number: 1,
      kind: "flat",
      diameter: 10,
      flute_length: 20,
      length: 50,
      holder: [
        [40, 0],
        [50, 30],
      ],
    }),
  ).toEqual({
    number: 1,
    cutting: [
      [0, 0],
      [10, 0],
      [10, 20],
    ],
    shank: [
      [10, 20],
      [10, 50],
    ],
    holder: [
      [40, 50],
      [50, 80],
    ],
  });
  const ball = shape_of({ number: 2, kind: "ball", diameter: 8, flute_length: 16 }).cutting;
  for (const [d, z] of ball.slice(1, -1)) expect(Math.hypot(d / 2, z - 4)).toBeCloseTo(4, 9);
  expect(shape_of({ number: 3, kind: "drill", diameter: 10, angle: 90, flute_length: 30 }).cutting[2]![1]).toBeCloseTo(
    5,
    12,
  );
});

test("the blank as text", () => {
  expect(box_of("box:-1,-2,-3,1,2,0")).toEqual([
    [-1, -2, -3],
    [1, 2, 0],
  ]);
  expect(
    stock_of([
      [-1, -2, -3],
      [1, 2, 0],
    ]),
  ).toBe("box:-1,-2,-3,1,2,0");
  expect([box_of("cylinder:0,0,-5,5,20"), box_of("box:1,2"), box_of("box:a,1,1,1,1,1")]).toEqual([null, null, null]);
  expect(
    proper([
      [0, 0, 0],
      [1, 1, 0],
    ]),
  ).toBe(false);
});

test("only the newest wish is carried out while one is under way", async () => {
  const done: number[] = [],
    open: (() => void)[] = [];
  const l = new Latest<number>((n) => {
    done.push(n);
    return new Promise((yes) => open.push(yes));
  });
  l.want(1);
  l.want(2);
  l.want(3);
  expect(done).toEqual([1]);
  open[0]!();
  await new Promise((r) => setTimeout(r));
  expect(done).toEqual([1, 3]);
});

test("what never ceases is still carried out now and then", () => {
  vi.useFakeTimers();
  let n = 0;
  const f = debounce(100, () => n++, 1000);
  for (let i = 0; i < 30; i++) {
    f();
    vi.advanceTimersByTime(50);
  }
  expect(n).toBe(1);
  vi.advanceTimersByTime(200);
  expect(n).toBe(2);
  vi.useRealTimers();
});

test("a tool that is added is the first one that the program calls and nothing tells of", () => {
  const tool = (number: number): Tool => ({ number, kind: "ball" });
  expect(new_tool([], []).number).toBe(1);
  expect(new_tool([], [0]).number).toBe(0); // a program without a T word cuts with the tool in the spindle
  expect(new_tool([tool(1), tool(7)], [1, 5, 7, 6]).number).toBe(5);
  expect(new_tool([tool(1), tool(7)], [1, 7]).number).toBe(8);
});
