// A piece of path as the scene needs it: the frame's columns, and values that are computed from them once.
import { is_rapid, jump, type PathFrame, type RowsFrame } from "../protocol/frames";
import type { Point } from "./types";

export interface Piece extends PathFrame {
  cut: [Point, Point] | null; // of the motions that are not rapid
  length: number; // of its drawn part, mm
  line_range: [number, number];
  feed_range: [number, number];
  speed_range: [number, number];
  kinds_seen: Set<number>;
  leans?: Float32Array; // from the tip into the tool, where it is tilted
  positions?: Float32Array; // of the joints that rotate the part, vertex by vertex
}

export function piece_of(frame: PathFrame): Piece {
  const piece: Piece = {
    ...frame,
    cut: null,
    length: 0,
    line_range: [Infinity, -Infinity],
    feed_range: [Infinity, -Infinity],
    speed_range: [Infinity, -Infinity],
    kinds_seen: new Set(),
  };
  measure(piece);
  return piece;
}

/// Adds directions of the tool or positions of the joints; returns false if their number differs from the vertices of
/// `piece`.
export function add_rows(piece: Piece, rows: RowsFrame): boolean {
  if (rows.count !== piece.count) return false;
  if (rows.kind === "directions") piece.leans = rows.values;
  else piece.positions = rows.values;
  return true;
}

function measure(p: Piece): void {
  const { kinds, at } = p,
    least: Point = [Infinity, Infinity, Infinity],
    greatest: Point = [-Infinity, -Infinity, -Infinity];
  const [lines, feeds, speeds] = [p.line_range, p.feed_range, p.speed_range];
  let last_kind = jump;
  for (let i = 1; i < p.count; i++) {
    const kind = kinds[4 * i]!,
      line = p.lines[i]!;
    if (kind === jump) continue;
    if (kind !== last_kind) p.kinds_seen.add((last_kind = kind));
    if (line < lines[0]) lines[0] = line;
    if (line > lines[1]) lines[1] = line;
    const x = at[3 * i]! - at[3 * i - 3]!,
      y = at[3 * i + 1]! - at[3 * i - 2]!,
      z = at[3 * i + 2]! - at[3 * i - 1]!;
    p.length += Math.sqrt(x * x + y * y + z * z);
    if (is_rapid(kind)) continue;
    const feed = p.feeds[i]!,
      speed = p.speeds[i]!;
    if (feed < feeds[0]) feeds[0] = feed;
    if (feed > feeds[1]) feeds[1] = feed;
    if (speed < speeds[0]) speeds[0] = speed;
    if (speed > speeds[1]) speeds[1] = speed;
    for (let k = 0; k < 3; k++) {
      const a = at[3 * i - 3 + k]!,
        b = at[3 * i + k]!;
      if (a < least[k]!) least[k] = a;
      if (b < least[k]!) least[k] = b;
      if (a > greatest[k]!) greatest[k] = a;
      if (b > greatest[k]!) greatest[k] = b;
    }
  }
  if (least[0] <= greatest[0]) p.cut = [least, greatest];
}
