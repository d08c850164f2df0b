// The detail of the drawn path: no finer than the screen shows, and never more than the budget of segments.
import { levels } from "../protocol/frames";
import type { Piece } from "./frame";

const finest = 0.001; // mm: greatest error of level 0; each level doubles it
const unseen_pixels = 0.5; // a smaller error is not visible

/// Returns the coarsest level whose error is invisible if a pixel is that many mm.
export function level_for(mm_per_pixel: number): number {
  const error = unseen_pixels * mm_per_pixel;
  if (!(error > finest)) return 0;
  return Math.min(levels - 1, Math.floor(Math.log2(error / finest)));
}

const coarsest = 8; // times the invisible error: instead of a coarser level, a part of the path is drawn exactly
const few = 20_000; // segments that are always drawn in full, so that no message is needed

/// Returns the level for these pieces at that size of a pixel.
export function level_of(pieces: readonly Piece[], mm_per_pixel: number, budget: number): number {
  return segments_at(pieces, 0) <= Math.min(few, budget)
    ? 0
    : Math.min(level_within(pieces, level_for(mm_per_pixel), budget), level_for(coarsest * mm_per_pixel));
}

/// Returns the first level, from the one that the screen requires, at which the pieces together keep to the budget.
export function level_within(pieces: readonly Piece[], wanted: number, budget: number): number {
  for (let level = wanted; level < levels - 1; level++) if (segments_at(pieces, level) <= budget) return level;
  return levels - 1;
}

/// Where lines are so dense that drawing all of them costs more than the budget, only every n-th run of a piece is
/// drawn. n is odd, because forward and return passes alternate.
export function every_of(cost: number, budget: number): number {
  if (cost <= budget) return 1;
  return Math.min(most_apart, 2 ** Math.ceil(Math.log2(cost / budget)) + 1);
}
const most_apart = 129;

export function segments_at(pieces: readonly Piece[], level: number): number {
  let sum = 0;
  for (const p of pieces) sum += Math.max(0, p.kept[level]! - 1);
  return sum;
}
