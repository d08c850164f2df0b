// Binary frames as the scene needs them (docs/panel-protocol.md, Frames): views into the frame, each length checked before it is believed.
import { frame_directions, frame_part, frame_path, frame_positions, head_of } from "../protocol/frames";
import { is_rapid, jump, type Point } from "./types";

export const levels = 16, most_vertices = 8192;
const head_bytes = 16, path_head_bytes = 80, column_bytes = 40;

export interface Piece {
  which: number; channel: number; count: number; start: number;
  least: Point; greatest: Point;   // of all vertices, machine coordinates
  cut: [Point, Point] | null;      // of the ways that are no rapids
  kept: Uint16Array;               // vertices at each level
  length: number;                  // of what is drawn of it, mm
  at: Float32Array; times: Float32Array; lines: Uint32Array; numbers: Uint32Array; feeds: Float32Array; speeds: Float32Array;
  tools: Uint16Array;              // tool and file by turns
  kinds: Uint8Array;               // kind, level, 0, 0
  line_range: [number, number]; feed_range: [number, number]; speed_range: [number, number];
  kinds_seen: Set<number>;
  leans?: Float32Array;            // from the tip into the tool, where it leans
  positions?: Float32Array;        // of the joints that turn the part, vertex by vertex
}
export interface PartMesh { points: Float32Array; triangles: Uint32Array; made_by: Uint16Array; lines: Uint32Array }

/// A piece of path; null where the frame is another kind, or is not as long as it says.
export function decode_path(frame: ArrayBuffer): Piece | null {
  const head = head_of(frame);
  if (!head || head.kind !== frame_path || head.count < 1 || head.count > most_vertices) return null;
  const n = head.count, first = head_bytes + path_head_bytes;
  if (frame.byteLength < first + n * column_bytes) return null;
  const v = new DataView(frame), column = (i: number): number => first + 12 * n + 4 * n * i;
  const corner = (at: number): Point => [v.getFloat32(at, true), v.getFloat32(at + 4, true), v.getFloat32(at + 8, true)];
  const piece: Piece = {
    which: head.which, channel: head.more, count: n, start: v.getFloat64(head_bytes, true), least: corner(24), greatest: corner(36), cut: null,
    kept: new Uint16Array(frame, 56, levels), length: 0, at: new Float32Array(frame, first, 3 * n), times: new Float32Array(frame, column(0), n),
    lines: new Uint32Array(frame, column(1), n), numbers: new Uint32Array(frame, column(2), n), feeds: new Float32Array(frame, column(3), n),
    speeds: new Float32Array(frame, column(4), n), tools: new Uint16Array(frame, column(5), 2 * n), kinds: new Uint8Array(frame, column(6), 4 * n),
    line_range: [Infinity, -Infinity], feed_range: [Infinity, -Infinity], speed_range: [Infinity, -Infinity], kinds_seen: new Set(),
  };
  if (!Number.isFinite(piece.start) || !all_finite(piece.at)) return null;
  measure(piece);
  return piece;
}

/// Nothing times zero is zero, but what is not finite.
function all_finite(values: Float32Array): boolean {
  let sum = 0;
  for (let i = 0; i < values.length; i++) sum += values[i]! * 0;
  return sum === 0;
}

function measure(p: Piece): void {
  const { kinds, at } = p, least: Point = [Infinity, Infinity, Infinity], greatest: Point = [-Infinity, -Infinity, -Infinity];
  const [lines, feeds, speeds] = [p.line_range, p.feed_range, p.speed_range];
  let last_kind = jump;
  for (let i = 1; i < p.count; i++) {
    const kind = kinds[4 * i]!, line = p.lines[i]!;
    if (kind === jump) continue;
    if (kind !== last_kind) p.kinds_seen.add((last_kind = kind));
    if (line < lines[0]) lines[0] = line;
    if (line > lines[1]) lines[1] = line;
    const x = at[3 * i]! - at[3 * i - 3]!, y = at[3 * i + 1]! - at[3 * i - 2]!, z = at[3 * i + 2]! - at[3 * i - 1]!;
    p.length += Math.sqrt(x * x + y * y + z * z);
    if (is_rapid(kind)) continue;
    const feed = p.feeds[i]!, speed = p.speeds[i]!;
    if (feed < feeds[0]) feeds[0] = feed;
    if (feed > feeds[1]) feeds[1] = feed;
    if (speed < speeds[0]) speeds[0] = speed;
    if (speed > speeds[1]) speeds[1] = speed;
    for (let k = 0; k < 3; k++) {
      const a = at[3 * i - 3 + k]!, b = at[3 * i + k]!;
      if (a < least[k]!) least[k] = a;
      if (b < least[k]!) least[k] = b;
      if (a > greatest[k]!) greatest[k] = a;
      if (b > greatest[k]!) greatest[k] = b;
    }
  }
  if (least[0] <= greatest[0]) p.cut = [least, greatest];
}

/// Directions of the tool for `piece`; null where they are not as many as its vertices.
export function decode_leans(frame: ArrayBuffer, piece: Piece): Float32Array | null {
  const head = head_of(frame);
  if (!head || head.kind !== frame_directions || head.count !== piece.count || frame.byteLength < head_bytes + 12 * head.count) return null;
  return new Float32Array(frame, head_bytes, 3 * head.count);
}

/// Positions of the joints that turn the part; null where they do not belong to `piece`.
export function decode_positions(frame: ArrayBuffer, piece: Piece): Float32Array | null {
  const head = head_of(frame), values = (frame.byteLength - head_bytes) / 4;
  if (!head || head.kind !== frame_positions || head.count !== piece.count || values < 1 || values % head.count !== 0) return null;
  const positions = new Float32Array(frame, head_bytes, values);
  return all_finite(positions) ? positions : null;
}

/// The part; null where a triangle names a point that is not there.
export function decode_part(frame: ArrayBuffer): PartMesh | null {
  const head = head_of(frame);
  if (!head || head.kind !== frame_part) return null;
  const n = head.count, t = head.more;
  if (frame.byteLength < head_bytes + 20 * n + 12 * t) return null;
  const from = head_bytes + 12 * n, after = from + 12 * t;
  const mesh = { points: new Float32Array(frame, head_bytes, 3 * n), triangles: new Uint32Array(frame, from, 3 * t), made_by: new Uint16Array(frame, after, 2 * n), lines: new Uint32Array(frame, after + 4 * n, n) };
  return mesh.triangles.every((i) => i < n) ? mesh : null;
}
