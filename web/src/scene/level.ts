// How finely the path is drawn: no finer than the screen shows, and never more than the budget of segments.
import { levels } from "../protocol/frames";
import type { Piece } from "./frame";

const finest = 0.001; // mm: how far level 0 may be off; each level doubles it
const unseen_pixels = 0.5; // what is off by less is not seen

/// The coarsest level whose error is not seen where a pixel is that many mm.
export function level_for(mm_per_pixel: number): number {
  const error = unseen_pixels * mm_per_pixel;
  if (!(error > finest)) return 0;
  return Math.min(levels - 1, Math.floor(Math.log2(error / finest)));
}

const coarsest = 8; // times as far off as what is not seen: what would be coarser is drawn in part, and true
const few = 20_000; // segments that are drawn as they are, so that nothing need be said of them

/// The level for these pieces at that size of a pixel.
export function level_of(pieces: readonly Piece[], mm_per_pixel: number, budget: number): number {
  return segments_at(pieces, 0) <= Math.min(few, budget)
    ? 0
    : Math.min(level_within(pieces, level_for(mm_per_pixel), budget), level_for(coarsest * mm_per_pixel));
}

/// From the level the screen asks for, up to the first one at which the pieces together keep to the budget.
export function level_within(pieces: readonly Piece[], wanted: number, budget: number): number {
  for (let level = wanted; level < levels - 1; level++) if (segments_at(pieces, level) <= budget) return level;
  return levels - 1;
}

/// Where lines lie so thick upon each other that drawing them all costs more than the budget: of the runs of a piece
/// only each so manieth is drawn. Odd, as ways there and back take turns.
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
