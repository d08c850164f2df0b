// Boxes in the view: the blank, the extents of the program, the machine's limits and zones (dashed).
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Vector3,
} from "three";
import type { Theme } from "./colours";
import type { Point, SceneBox } from "./types";

const edges = [
  [0, 1],
  [2, 3],
  [4, 5],
  [6, 7],
  [0, 2],
  [1, 3],
  [4, 6],
  [5, 7],
  [0, 4],
  [1, 5],
  [2, 6],
  [3, 7],
] as const; // along X, Y, Z
const dashes = 60; // along the longest edge of a dashed box

export const corner = (box: readonly [Point, Point], i: number): Point => [
  box[i & 1]![0],
  box[(i >> 1) & 1]![1],
  box[(i >> 2) & 1]![2],
];

export function box_lines(box: SceneBox, theme: Theme): LineSegments {
  const dashed = box.kind !== "stock" && box.kind !== "extents",
    colour = box.over ? theme.over : theme[box.kind];
  const points = edges.flatMap(([a, b]) => [
    ...corner(box.box as [Point, Point], a),
    ...corner(box.box as [Point, Point], b),
  ]);
  const size = Math.max(...[0, 1, 2].map((k) => box.box[1][k]! - box.box[0][k]!));
  const material = dashed
    ? new LineDashedMaterial({ color: colour, dashSize: 0.6 * (size / dashes), gapSize: 0.4 * (size / dashes) })
    : new LineBasicMaterial({ color: colour });
  material.transparent = true;
  material.opacity = box.kind === "extents" ? 0.55 : 0.9;
  const lines = new LineSegments(
    new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(points), 3)),
    material,
  );
  if (dashed) lines.computeLineDistances();
  return lines;
}

/// Returns a box in which unlimited sides are set slightly outside `all`.
export function bounded(
  box: readonly [readonly (number | null)[], readonly (number | null)[]],
  all: Box3,
): [Point, Point] {
  const margin = all.isEmpty() ? 100 : 0.1 * all.min.distanceTo(all.max) + 1,
    within = all.isEmpty() ? new Box3(new Vector3(), new Vector3()) : all;
  const side = (v: number | null | undefined, otherwise: number): number =>
    typeof v === "number" && Number.isFinite(v) ? v : otherwise;
  const [least, greatest] = [within.min.toArray(), within.max.toArray()];
  const out: [Point, Point] = [
    [0, 0, 0],
    [0, 0, 0],
  ];
  for (let k = 0; k < 3; k++) {
    out[0][k] = side(box[0][k], Math.min(least[k]!, side(box[1][k], Infinity)) - margin);
    out[1][k] = side(box[1][k], Math.max(greatest[k]!, side(box[0][k], -Infinity)) + margin);
  }
  return out;
}

/// True if the path leaves a box; `slack` allows for rounding.
export function goes_beyond(
  path: Box3,
  box: readonly [readonly (number | null)[], readonly (number | null)[]],
  slack = 1e-3,
): boolean {
  if (path.isEmpty()) return false;
  const [least, greatest] = [path.min.toArray(), path.max.toArray()];
  return [0, 1, 2].some(
    (k) => least[k]! < (box[0][k] ?? -Infinity) - slack || greatest[k]! > (box[1][k] ?? Infinity) + slack,
  );
}

/// Returns, for each axis, the middle of the one of its four edges that is lowest on the screen: the position of its
/// figure. `height` of a point on the screen counts downwards.
export function figure_places(box: readonly [Point, Point], height: (p: Point) => number): Point[] {
  return [0, 1, 2].map((axis) => {
    const middles = edges.slice(4 * axis, 4 * axis + 4).map(([a, b]) => {
      const p = corner(box, a),
        q = corner(box, b);
      return [0, 1, 2].map((k) => (p[k]! + q[k]!) / 2) as Point;
    });
    return middles.reduce((low, m) => (height(m) > height(low) ? m : low));
  });
}
