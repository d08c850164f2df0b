// Tests a restart in the middle of a program: requests until it is found, the approach that is drawn, what stays
// unchanged.
import { describe, expect, it, vi } from "vitest";
import { Restart } from "../src/model/restart";
import { Signal } from "../src/model/signal";
import type { Operator } from "../src/model/operator";

const sheet = {
  ready: true,
  number: 1,
  beside: [] as object[],
  line: 9,
  file: "",
  text: "X30",
  calls: [],
  normal: "Z",
  zero: { X: 0, Y: 0, Z: -8 },
  blocks: [],
  by_hand: "",
  search: null,
  rows: [
    { key: "tool:", kind: "tool", name: "", wanted: 5, now: 0, by: "line", may_be_left: true },
    { key: "origin:Z", kind: "origin", name: "Z", wanted: -50, now: -50, by: "", may_be_left: false },
  ],
  way: [
    { rapid: true, to: { Z: 40 }, feed: 0 },
    { rapid: true, to: { X: 30, Y: 20 }, feed: 0 },
    { rapid: false, to: { Z: -11 }, feed: 100 },
  ],
};

function made(answers: (what: string, body: Record<string, unknown>) => object | null) {
  const asked: [string, Record<string, unknown>][] = [];
  const operator = {
    on_panel: new Signal(),
    panel: { machine: { X: 1, Y: 2, Z: 3 } },
    ask: (what: string, body: Record<string, unknown>) => {
      asked.push([what, body]);
      return Promise.resolve(answers(what, body));
    },
  };
  return { restart: new Restart(operator as unknown as Operator), operator, asked };
}

describe("a restart", () => {
  it("is asked for until the place is found", async () => {
    vi.useFakeTimers();
    let times = 0;
    const { restart, asked } = made(() => (++times < 4 ? { ready: false } : sheet));
    void restart.find({ line: 9, pass: 2 });
    await vi.advanceTimersByTimeAsync(1000);
    expect(asked.length).toBe(4);
    expect(asked[0]![1]).toMatchObject({ line: 9, pass: 2, above: 2 });
    expect([restart.searching, restart.sheet?.line]).toEqual([false, 9]);
    vi.useRealTimers();
  });

  it("a later wish puts an end to the one before", async () => {
    const late: ((v: object) => void)[] = [];
    const { restart } = made(() => new Promise((yes) => late.push(yes)) as unknown as object);
    const first = restart.find({ line: 1 }),
      second = restart.find({ line: 2 });
    late[1]!({ ...sheet, line: 2 });
    late[0]!({ ...sheet, line: 1 });
    await Promise.all([first, second]);
    expect(restart.sheet?.line).toBe(2);
  });

  it("draws the way of the tip, in the coordinates of the path: without the tool's length", async () => {
    const { restart } = made(() => sheet);
    await restart.find({ line: 9 });
    expect(restart.tips()).toEqual([
      [1, 2, 3 + 8 - 50],
      [1, 2, 40 + 8 - 50],
      [30, 20, 40 + 8 - 50],
      [30, 20, -11 + 8 - 50],
    ]);
    restart.set_point(0, "Z", 60); // work coordinate
    expect(restart.way()[0]!.to.Z).toBe(52);
    expect(sheet.way[0]!.to.Z).toBe(40);
  });

  it("goes with what is left as it is, and is put away then", async () => {
    const { restart, asked } = made((what) => (what === "restart" ? sheet : {}));
    await restart.find({ line: 9 });
    restart.set_leave("tool:", true);
    await restart.go();
    expect(asked.at(-1)).toEqual(["go_there", { line: 9, leave: ["tool:"], ways: [{ channel: 1, way: sheet.way }] }]);
    expect([restart.sheet, restart.way()]).toEqual([null, []]);
  });

  it("leads each of several channels, in the order that is chosen", async () => {
    const beside = {
      number: 2,
      line: 4,
      text: "G0 X5",
      stands: "before",
      rows: [{ key: "2/tool:", kind: "tool", name: "", wanted: 7, now: 0, by: "line", may_be_left: true }],
      way: [{ rapid: true, to: { X: 1, Z: 5 }, feed: 0 }],
      zero: { X: 0, Z: 100 },
      blocks: [],
      by_hand: "",
    };
    const { restart, asked } = made((what) => (what === "restart" ? { ...sheet, beside: [beside] } : {}));
    await restart.find({ line: 9 });
    restart.set_leave("2/tool:", true);
    restart.set_point(0, "Z", 50, 2);
    restart.go_first(2);
    await restart.find({ line: 9 }); // again, as after a change of the clearance
    expect([...restart.leave]).toEqual(["2/tool:"]);
    expect(restart.ways.map((w) => w.channel)).toEqual([2, 1]);
    restart.set_point(0, "Z", 50, 2);
    await restart.go();
    expect(asked.at(-1)![1]).toMatchObject({
      leave: ["2/tool:"],
      ways: [
        { channel: 2, way: [{ to: { X: 1, Z: 150 } }] },
        { channel: 1, way: sheet.way },
      ],
    });
    expect(beside.way[0]!.to.Z).toBe(5);
  });

  it("stays where it was refused", async () => {
    const { restart, operator } = made((what) => (what === "restart" ? sheet : null));
    await restart.find({ line: 9 });
    await restart.go();
    expect(restart.sheet).not.toBeNull();
    operator.on_panel.emit(null as never);
    expect(restart.sheet).toBeNull();
  });
});
