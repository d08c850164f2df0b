// What of one piece is drawn at a level: each segment with both its ends and one colour. Only what is drawn is copied, so the graphics card holds no more than the budget.
import { colour_of, type Ranges, type Theme } from "./colours";
import type { Piece } from "./frame";
import { is_rapid, jump, type ColourBy, type Point, type SceneFilter } from "./types";

export interface Look { level: number; filter: SceneFilter; by: ColourBy; ranges: Ranges; theme: Theme; zero: Point }
export interface Segments { points: Float32Array; colours: Uint8Array; ends: Uint32Array } // ends: the vertex at which each segment ends

export function segments_of(p: Piece, look: Look): Segments {
  const pairs: number[] = [];
  let before = 0;
  for (let i = 1; i < p.count; i++) {
    if (p.kinds[4 * i + 1]! < look.level && i < p.count - 1) continue;
    if (p.kinds[4 * i] !== jump && shown(p, i, look.filter, look.zero[2])) pairs.push(before, i);
    before = i;
  }
  return copied(p, pairs, look);
}

function copied(p: Piece, pairs: readonly number[], look: Look): Segments {
  const n = pairs.length / 2, points = new Float32Array(6 * n), colours = new Uint8Array(8 * n), ends = new Uint32Array(n);
  for (let s = 0; s < n; s++) {
    const end = pairs[2 * s + 1]!, colour = colour_of(p, end, look.by, look.ranges, look.theme);
    ends[s] = end;
    for (let e = 0; e < 2; e++) {
      for (let k = 0; k < 3; k++) points[6 * s + 3 * e + k] = p.at[3 * pairs[2 * s + e]! + k]! - look.zero[k]!;
      colours.set(colour, 8 * s + 4 * e);
    }
  }
  return { points, colours, ends };
}

export function shown(p: Piece, i: number, f: SceneFilter, zero_z: number): boolean {
  if (!f.rapids && is_rapid(p.kinds[4 * i]!)) return false;
  if (f.tools && !f.tools.includes(p.tools[2 * i]!)) return false;
  const z = p.at[3 * i + 2]! - zero_z, line = p.lines[i]!;
  if (f.depth && (z < f.depth[0] || z > f.depth[1])) return false;
  return !f.lines || (line >= f.lines[0] && line <= f.lines[1]);
}

export const piece_shown = (p: Piece, f: SceneFilter): boolean => (f.other || !(p.which & 1)) && (f.programmed || !(p.which & 2));
