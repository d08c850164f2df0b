// The circle of an arc of the path: from three of its vertices, in any plane; for a helix the circle as seen along its
// axis.
import { is_arc } from "../protocol/frames";
import type { Piece } from "./frame";
import type { Point } from "./types";

export interface Circle {
  centre: Point;
  radius: number;
}

export const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const plus = (a: Point, b: Point, by = 1): Point => [a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]];
export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Point): number => Math.hypot(...a);

const along_axis = 0.94; // cosine: the plane of three points of a helix is slightly off its circle's plane

/// Returns the circle of the arc that ends at or passes vertex `i` of `p`, machine coordinates; null if it is no arc
/// or nearly straight.
export function arc_at(p: Piece, i: number): Circle | null {
  const kind = p.kinds[4 * i]!;
  if (!is_arc(kind)) return null;
  const same = (k: number): boolean => k > 0 && k < p.count && p.numbers[k] === p.numbers[i] && p.kinds[4 * k] === kind;
  let first = i,
    last = i;
  while (same(first)) first--;
  while (same(last + 1)) last++;
  const n = last - first;
  if (n < 2) return null;
  const at = (k: number): Point => [p.at[3 * k]!, p.at[3 * k + 1]!, p.at[3 * k + 2]!];
  const third = Math.max(1, Math.floor(n / 3)); // the ends of a full circle are one point
  return circle(at(first), at(first + third), at(first + 2 * third));
}

/// Returns the circle through three points. If their plane is nearly perpendicular to an axis, they are projected
/// along that axis.
export function circle(a: Point, b: Point, c: Point): Circle | null {
  const u = minus(b, a);
  let v = minus(c, a),
    n = cross(u, v);
  const axis = [0, 1, 2].find((k) => Math.abs(n[k]!) > along_axis * length(n));
  if (axis !== undefined) {
    u[axis] = v[axis] = 0;
    n = cross(u, v);
  }
  const uu = dot(u, u),
    vv = dot(v, v),
    nn = dot(n, n);
  if (!(nn > 1e-12 * uu * vv) || !(nn > 1e-18)) return null;
  const to = cross(plus([uu * v[0], uu * v[1], uu * v[2]], u, -vv), n); // from the first point to the centre, times 2 nn
  const off: Point = [to[0] / (2 * nn), to[1] / (2 * nn), to[2] / (2 * nn)];
  return { centre: plus(a, off), radius: length(off) };
}
