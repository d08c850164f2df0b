// Tests marks in the view: boxes without some of their sides, paths that leave them, flags, figures of the legend.
import { Box3, Vector3 } from "three";
import { expect, test } from "vitest";
import type { Mark } from "../src/protocol/types";
import { bounded, corner, figure_places, goes_beyond } from "../src/scene/boxes";
import type { Point } from "../src/scene/types";
import { flags_of } from "../src/ui/flags";
import { ramp_figures } from "../src/ui/legend";

const path = (least: Point, most: Point): Box3 => new Box3(new Vector3(...least), new Vector3(...most));
const mark = (kind: Mark["kind"], at: number): Mark => ({ kind, at, line: 1, text: "" });

test("a side without a limit stands outside of the path and of the side that has one", () => {
  const [least, most] = bounded(
    [
      [-50, null, null],
      [50, null, -300],
    ],
    path([0, 0, -10], [10, 20, 5]),
  );
  expect([least[0], most[0]]).toEqual([-50, 50]);
  expect(least[1]).toBeLessThan(0);
  expect(most[1]).toBeGreaterThan(20);
  expect(most[2]).toBe(-300);
  expect(least[2]).toBeLessThan(-300);
});

test("a path of nothing leaves a box that can be drawn", () => {
  const [least, most] = bounded(
    [
      [null, null, null],
      [null, null, null],
    ],
    new Box3(),
  );
  for (let k = 0; k < 3; k++) expect(most[k]! - least[k]!).toBeGreaterThan(0);
});

test("beyond a limit is beyond, on it is not", () => {
  const limits = [
    [0, null, null],
    [100, null, null],
  ] as const;
  expect(goes_beyond(path([0, -1e6, 0], [100, 1e6, 0]), limits)).toBe(false);
  expect(goes_beyond(path([0, 0, 0], [100.0005, 0, 0]), limits)).toBe(false); // rounding
  expect(goes_beyond(path([0, 0, 0], [100.01, 0, 0]), limits)).toBe(true);
  expect(goes_beyond(path([-0.01, 0, 0], [50, 0, 0]), limits)).toBe(true);
  expect(goes_beyond(new Box3(), limits)).toBe(false);
});

test("a figure stands at the lowest edge of its axis", () => {
  const box: [Point, Point] = [
    [0, 0, 0],
    [10, 20, 30],
  ];
  expect(new Set(Array.from({ length: 8 }, (_, i) => corner(box, i).join())).size).toBe(8);
  expect(figure_places(box, (p) => -p[2])[0]![2]).toBe(0); // seen from the side: the lower edges
  expect(figure_places(box, (p) => p[2])[0]).toEqual([5, 0, 30]);
  expect(figure_places(box, (p) => p[0] + p[1])[2]).toEqual([10, 20, 15]);
});

test("of too many marks the gravest stay; where an alarm stopped it there is no end", () => {
  const marks = [...Array.from({ length: 400 }, (_, i) => mark("dwell", i)), mark("alarm", 500)];
  const flags = flags_of(marks, 500, (at) => [at, 0, 0]);
  expect(flags.length).toBe(151);
  expect(flags[0]!.kind).toBe("start");
  expect(flags.some((f) => f.kind === "alarm")).toBe(true);
  expect(flags.some((f) => f.kind === "end")).toBe(false);
  expect(flags_of([mark("tool", 3)], 9, (at) => [at, 0, 0]).map((f) => [f.kind, f.time])).toEqual([
    ["start", 0],
    ["tool", 3],
    ["end", 9],
  ]);
  expect(flags_of([mark("tool", 3)], 9, () => null)).toEqual([]); // the position is unknown
});

test("a ramp has as many places as its range asks for", () => {
  expect(ramp_figures("feed", [100, 500])).toEqual(["100", "200", "300", "400", "500"]);
  expect(ramp_figures("depth", [-2, 0])[0]).toContain("2.000");
  expect(ramp_figures("feed", [300, 300])).toEqual(["300"]);
  expect(ramp_figures("feed", [Infinity, -Infinity])).toEqual([]);
});
