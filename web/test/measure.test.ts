// Tests circles through vertices, anchors, distances between points, edges and centres.
import { describe, expect, it } from "vitest";
import { circle } from "../src/scene/arc";
import { anchor_of, distance_between } from "../src/scene/measure";
import type { Anchor, Point } from "../src/scene/types";

const close = (a: readonly number[], b: readonly number[]): void =>
  a.forEach((v, i) => expect(v).toBeCloseTo(b[i]!, 9));

describe("a circle through three points", () => {
  it("in each plane", () => {
    for (const [k, l] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const) {
      const at = (degrees: number): Point => {
        const p: Point = [7, 7, 7];
        p[k] = 3 + 5 * Math.cos(degrees / 57.29577951308232);
        p[l] = -2 + 5 * Math.sin(degrees / 57.29577951308232);
        return p;
      };
      const c = circle(at(10), at(100), at(250))!;
      expect(c.radius).toBeCloseTo(5, 9);
      const centre = [7, 7, 7];
      centre[k] = 3;
      centre[l] = -2;
      close(c.centre, centre);
    }
  });
  it("of a helix as it is seen along its axis, at the height of its first point", () => {
    const c = circle([5, 0, 1], [0, 5, 1.5], [-5, 0, 2])!;
    expect(c.radius).toBeCloseTo(5, 9);
    close(c.centre, [0, 0, 1]);
  });
  it("in a tilted plane", () => {
    const s = Math.SQRT1_2,
      c = circle([4, 0, 0], [0, 4 * s, 4 * s], [-4, 0, 0])!;
    expect(c.radius).toBeCloseTo(4, 9);
    close(c.centre, [0, 0, 0]);
  });
  it("is none where they lie on a line, or on each other", () => {
    expect(circle([0, 0, 0], [1, 0, 0], [2, 0, 0])).toBeNull();
    expect(circle([0, 0, 0], [0, 0, 0], [2, 0, 0])).toBeNull();
  });
});

describe("measuring", () => {
  const point = (...place: Point): Anchor => ({ kind: "point", place, line: 1 });
  const edge = (place: Point, direction: Point): Anchor => ({ kind: "edge", place, direction, line: 1 });
  it("takes ends as points, arcs as centres, the middle of a way as an edge", () => {
    expect(anchor_of([0, 0, 0], [10, 0, 0], 0, null, 5)).toEqual({ kind: "point", place: [0, 0, 0], line: 5 });
    expect(anchor_of([0, 0, 0], [10, 0, 0], 1, { centre: [1, 1, 1], radius: 2 }, 5).kind).toBe("point");
    expect(anchor_of([0, 0, 0], [10, 0, 0], 0.3, { centre: [1, 1, 1], radius: 2 }, 5)).toEqual({
      kind: "centre",
      place: [1, 1, 1],
      radius: 2,
      line: 5,
    });
    expect(anchor_of([0, 0, 0], [10, 0, 0], 0.3, null, 5)).toEqual({
      kind: "edge",
      place: [3, 0, 0],
      direction: [1, 0, 0],
      line: 5,
    });
    expect(anchor_of([1, 1, 1], [1, 1, 1], 0.5, null, 5).kind).toBe("point");
  });
  it("between points", () => {
    const d = distance_between(point(1, 2, 3), point(4, 6, 3));
    expect([d.distance, d.angle]).toEqual([5, null]);
    expect(d.delta).toEqual([3, 4, 0]);
  });
  it("from a point to an edge is square to it, either way round", () => {
    for (const d of [
      distance_between(point(5, 3, 4), edge([0, 0, 0], [1, 0, 0])),
      distance_between(edge([0, 0, 0], [1, 0, 0]), point(5, 3, 4)),
    ])
      expect(d.distance).toBeCloseTo(5, 9);
  });
  it("between parallel edges, crossing ones and ones that pass each other", () => {
    expect(distance_between(edge([0, 0, 0], [1, 0, 0]), edge([7, 3, 4], [-1, 0, 0]))).toMatchObject({
      distance: 5,
      angle: null,
    });
    const crossing = distance_between(edge([-9, 0, 0], [1, 0, 0]), edge([0, 4, 0], [Math.SQRT1_2, Math.SQRT1_2, 0]));
    expect(crossing.distance).toBeCloseTo(0, 9);
    expect(crossing.angle).toBeCloseTo(45, 9);
    close(crossing.from, [-4, 0, 0]);
    const past = distance_between(edge([3, 0, 0], [1, 0, 0]), edge([0, 5, 6], [0, 1, 0]));
    expect([past.distance, past.angle]).toEqual([6, 90]);
    close(past.to, [0, 0, 6]);
  });
});
