// The point, centre or edge that a click in the view measures from, and the distance between two of them. A corner is
// a point, an arc its centre, a straight motion an edge.
import { cross, dot, length, minus, plus, type Circle } from "./arc";
import type { Anchor, Distance, Point } from "./types";

/// `part` of the motion from `a` to `b` was hit: at its ends it is a point.
export function anchor_of(a: Point, b: Point, part: number, arc: Circle | null, line: number): Anchor {
  const way = minus(b, a),
    long = length(way);
  if (part === 0 || part === 1 || !(long > 0)) return { kind: "point", place: part === 0 ? a : b, line };
  if (arc) return { kind: "centre", place: arc.centre, radius: arc.radius, line };
  return { kind: "edge", place: plus(a, way, part), direction: [way[0] / long, way[1] / long, way[2] / long], line };
}

const parallel = 1e-6; // sine of the angle between two edges

export function distance_between(a: Anchor, b: Anchor): Distance {
  if (a.direction && b.direction) return between_edges(a.place, a.direction, b.place, b.direction);
  if (a.direction) return told(foot(b.place, a.place, a.direction), b.place, null);
  if (b.direction) return told(a.place, foot(a.place, b.place, b.direction), null);
  return told(a.place, b.place, null);
}

function between_edges(p: Point, u: Point, q: Point, v: Point): Distance {
  const n = cross(u, v),
    sine = length(n);
  if (sine < parallel) return told(p, foot(p, q, v), null);
  const w = minus(p, q),
    uv = dot(u, v),
    uw = dot(u, w),
    vw = dot(v, w),
    nn = sine * sine; // the shortest distance between two lines
  const s = (uv * vw - uw) / nn,
    t = (vw - uv * uw) / nn;
  return told(plus(p, u, s), plus(q, v, t), Math.atan2(sine, Math.abs(uv)) * (180 / Math.PI));
}

const foot = (p: Point, on: Point, direction: Point): Point => plus(on, direction, dot(minus(p, on), direction));
function told(from: Point, to: Point, angle: number | null): Distance {
  const delta = minus(to, from);
  return { from, to, distance: length(delta), delta, angle };
}
