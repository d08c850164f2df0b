// Tests the arithmetic of the slider.
import { expect, test } from "vitest";
import { clusters, next_mark, played, slider_of, times_of } from "../src/model/time";
import { clock, coordinate, grouped } from "../src/ui/figures";
import type { Mark } from "../src/protocol/types";

const mark = (at: number, kind: Mark["kind"]): Mark => ({ at, kind, line: 1, text: "" });

test("the next mark is the nearest one of its kinds, never the one stood upon", () => {
  const marks = [mark(30, "tool"), mark(10, "tool"), mark(20, "alarm")];
  expect(next_mark(marks, ["tool"], 10, 1)?.at).toBe(30);
  expect(next_mark(marks, ["tool"], 30, -1)?.at).toBe(10);
  expect(next_mark(marks, ["tool"], 10, -1)).toBeNull();
  expect(next_mark(marks, ["alarm", "warning"], 0, 1)?.at).toBe(20);
});

test("playing goes at its pace, ends at the end, begins anew in a loop", () => {
  expect(played(1, 100, 10, 60, null)).toBe(2);
  expect(played(59.5, 1000, 1, 60, null)).toBe(60);
  expect(played(4.9, 200, 1, 60, [3, 5])).toBe(3);
});

test("paces from a tenth to a thousand", () => {
  expect([0, 0.25, 0.5, 0.75, 1].map(times_of)).toEqual([0.1, 1, 10, 100, 1000]);
  expect(slider_of(times_of(0.25))).toBeCloseTo(0.25, 12);
});

test("marks on the same pixels become one, the gravest kind", () => {
  const c = clusters([mark(5.001, "alarm"), mark(5, "tool"), mark(9, "tool")], 10, 1000);
  expect(c.map((x) => [x.kind, x.marks.length])).toEqual([
    ["alarm", 2],
    ["tool", 1],
  ]);
});

test("figures", () => {
  expect([0, 59.96, 61.25, 3600, 36061].map(clock)).toEqual(["0:00.0", "1:00.0", "1:01.3", "1:00:00", "10:01:01"]);
  expect([coordinate(-0.0001), coordinate(1.5), coordinate(undefined)]).toEqual(["0.000", "1.500", "–"]);
  expect(grouped(1234567.5)).toBe("1\u202f234\u202f567.5");
});
