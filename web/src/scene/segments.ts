// The segments of one piece that are drawn at a level: both ends and one colour each, in machine coordinates. Only
// what is drawn is copied, so the graphics card holds no more than the budget.
import { is_rapid, jump, most_vertices } from "../protocol/frames";
import { painter, type Ranges, type Theme } from "./colours";
import type { Piece } from "./frame";
import type { ColourBy, SceneFilter } from "./types";

export interface Look {
  level: number;
  filter: SceneFilter;
  by: ColourBy;
  ranges: Ranges;
  theme: Theme;
  zero_z: number;
  every?: number;
  runs_before?: number;
} // `every`: only every n-th run; the number of runs before the piece
export interface Segments {
  points: Float32Array;
  colours: Uint32Array;
  starts: Uint32Array;
  ends: Uint32Array;
} // colours: of both ends; starts, ends: vertices
export const no_segments: Segments = {
  points: new Float32Array(),
  colours: new Uint32Array(),
  starts: new Uint32Array(),
  ends: new Uint32Array(),
};

export const run = 256,
  runs = Math.ceil(most_vertices / run); // vertices that are drawn together, or not
const from_to = new Uint32Array(2 * most_vertices); // of the current piece: pairs of vertices

export function segments_of(p: Piece, look: Look): Segments {
  const { kinds, count } = p,
    { level } = look,
    all = shows_all(look.filter);
  const every = look.every ?? 1,
    runs_before = look.runs_before ?? 0;
  let before = 0,
    n = 0;
  for (let i = 1; i < count; i++) {
    if (kinds[4 * i + 1]! < level && i < count - 1) continue;
    if (
      kinds[4 * i] !== jump &&
      (all || shown(p, i, look.filter, look.zero_z)) &&
      (every === 1 || (runs_before + Math.floor((i - 1) / run)) % every === 0)
    ) {
      from_to[n] = before;
      from_to[n + 1] = i;
      n += 2;
    }
    before = i;
  }
  return copied(p, n / 2, look);
}

function copied(p: Piece, n: number, look: Look): Segments {
  const points = new Float32Array(6 * n),
    colours = new Uint32Array(2 * n),
    starts = new Uint32Array(n),
    ends = new Uint32Array(n);
  const paint = painter(p, look.by, look.ranges, look.theme),
    { at } = p;
  for (let s = 0; s < n; s++) {
    const a = (starts[s] = from_to[2 * s]!),
      b = (ends[s] = from_to[2 * s + 1]!),
      to = 6 * s;
    colours[2 * s] = colours[2 * s + 1] = paint(b);
    points[to] = at[3 * a]!;
    points[to + 1] = at[3 * a + 1]!;
    points[to + 2] = at[3 * a + 2]!;
    points[to + 3] = at[3 * b]!;
    points[to + 4] = at[3 * b + 1]!;
    points[to + 5] = at[3 * b + 2]!;
  }
  return { points, colours, starts, ends };
}

const shows_all = (f: SceneFilter): boolean => f.rapids && !f.tools && !f.depth && !f.lines;

export function shown(p: Piece, i: number, f: SceneFilter, zero_z: number): boolean {
  if (!f.rapids && is_rapid(p.kinds[4 * i]!)) return false;
  if (f.tools && !f.tools.includes(p.tools[2 * i]!)) return false;
  const z = p.at[3 * i + 2]! - zero_z,
    line = p.lines[i]!;
  if (f.depth && (z < f.depth[0] || z > f.depth[1])) return false;
  return !f.lines || (line >= f.lines[0] && line <= f.lines[1]);
}

export const piece_shown = (p: Piece, f: SceneFilter): boolean =>
  (f.other || !(p.which & 1)) && (f.programmed || !(p.which & 2));
