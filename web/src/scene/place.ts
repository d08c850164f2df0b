// The position of the tool at an instant: the piece by its start, the motion by its time, the position by
// interpolation.
import { jump } from "../protocol/frames";
import type { Piece } from "./frame";
import type { Point } from "./types";

export interface Place {
  at: Point;
  tool: number;
  lean: Point | null;
  positions: number[] | null;
} // positions: of the joints that rotate the part

/// Returns the index of the first of `count` ordered values that is not below `wanted`; `count` if there is none.
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

/// Returns machine coordinates at `time`; before the first vertex and after the last one the tool is at that vertex.
/// `pieces` are in order of time.
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
  if (p.kinds[4 * i] === jump && part < 1) part = 0; // the path of a jump is unknown
  const of = (values: Float32Array): number[] => between(values, values.length / p.count, before, i, part);
  return {
    at: of(p.at) as Point,
    tool: p.tools[2 * i]!,
    lean: p.leans ? (of(p.leans) as Point) : null,
    positions: p.positions ? of(p.positions) : null,
  };
}

/// Interpolates `each` values per vertex.
function between(values: Float32Array, each: number, a: number, b: number, part: number): number[] {
  return Array.from(
    { length: each },
    (_, k) => values[each * a + k]! + part * (values[each * b + k]! - values[each * a + k]!),
  );
}
