// Where the tool is at an instant: the piece by its start, the motion by its time, the place in between.
import { jump } from "../protocol/frames";
import type { Piece } from "./frame";
import type { Point } from "./types";

export interface Place {
  at: Point;
  tool: number;
  lean: Point | null;
  positions: number[] | null;
} // positions: of the joints that turn the part

/// The first of `count` ordered values that is not below `wanted`; `count` where there is none.
export function first_from(count: number, value: (i: number) => number, wanted: number): number {
  let low = 0,
    high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (value(middle) < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}

/// Machine coordinates at `time`; before the first vertex and after the last one the tool stands there. `pieces` are in
/// order of time.
export function place_at(pieces: readonly Piece[], time: number): Place | null {
  if (!pieces.length) return null;
  const p = pieces[Math.max(0, first_from(pieces.length, (i) => pieces[i]!.start, time) - 1)]!;
  const t = time - p.start;
  const i = Math.min(
    p.count - 1,
    first_from(p.count, (k) => p.times[k]!, t),
  );
  const before = Math.max(0, i - 1),
    span = p.times[i]! - p.times[before]!;
  let part = span > 0 ? Math.min(1, Math.max(0, (t - p.times[before]!) / span)) : 1;
  if (p.kinds[4 * i] === jump && part < 1) part = 0; // nothing is known of the way of a jump
  const of = (values: Float32Array): number[] => between(values, values.length / p.count, before, i, part);
  return {
    at: of(p.at) as Point,
    tool: p.tools[2 * i]!,
    lean: p.leans ? (of(p.leans) as Point) : null,
    positions: p.positions ? of(p.positions) : null,
  };
}

/// Of `each` values a vertex.
function between(values: Float32Array, each: number, a: number, b: number, part: number): number[] {
  return Array.from(
    { length: each },
    (_, k) => values[each * a + k]! + part * (values[each * b + k]! - values[each * a + k]!),
  );
}
