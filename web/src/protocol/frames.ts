// The only file that knows the layout of binary frames (docs/panel-protocol.md, Frames): views into the frame, without
// copies; each length is checked before it is used. Writers of frames (a report) fill the same views.

export const levels = 16,
  most_vertices = 8192;

/// Kinds of motion; the values of a vertex belong to the motion that ends there.
export const jump = 0,
  rapid = 1,
  clockwise = 3,
  counter_clockwise = 4,
  home = 6,
  spline = 8;
export const is_rapid = (kind: number): boolean => kind === rapid || kind === home;
export const is_arc = (kind: number): boolean => kind === clockwise || kind === counter_clockwise;

type Triple = [number, number, number];
/// `which` path of which channel; `count` of vertices.
interface OfPath {
  which: number;
  channel: number;
  count: number;
}
export interface PathColumns {
  kept: Uint16Array; // vertices at each level
  at: Float32Array; // x, y, z alternating
  times: Float32Array;
  lines: Uint32Array;
  numbers: Uint32Array;
  feeds: Float32Array;
  speeds: Float32Array;
  tools: Uint16Array; // tool and file alternating
  kinds: Uint8Array; // kind, level, 0, 0
}
/// A piece of path; least and greatest corner of its vertices, machine coordinates.
export interface PathFrame extends OfPath, PathColumns {
  kind: "path";
  start: number;
  least: Triple;
  greatest: Triple;
}
/// Values for each vertex of the preceding piece: directions from the tip into the tool, or positions of the joints
/// that rotate the part.
export interface RowsFrame extends OfPath {
  kind: "directions" | "positions";
  values: Float32Array;
}
/// Any frame of a path.
export type OfPathFrame = PathFrame | RowsFrame;
export interface PartFrame {
  kind: "part";
  points: Float32Array;
  triangles: Uint32Array;
  made_by: Uint16Array;
  lines: Uint32Array;
}
export type Frame = OfPathFrame | PartFrame;

const kinds = { path: 1, directions: 2, part: 3, positions: 4 };
const head_bytes = 16,
  path_head_bytes = 80,
  column_bytes = 40;
const start_at = 16,
  least_at = 24,
  greatest_at = 36,
  first_at = 48,
  first_number_at = 52,
  kept_at = 56;

/// Returns null if it is not a frame, is shorter than its header states, or has an index or a point that is invalid.
export function read_frame(frame: ArrayBuffer): Frame | null {
  if (frame.byteLength < head_bytes) return null;
  const [kind, which, count, more] = new Uint32Array(frame, 0, 4) as unknown as [number, number, number, number];
  if (kind === kinds.part) return read_part(frame, count, more);
  if (count < 1 || count > most_vertices) return null;
  if (kind === kinds.path) return read_path(frame, { which, channel: more, count });
  if (kind === kinds.directions) return read_directions(frame, { which, channel: more, count });
  return kind === kinds.positions ? read_positions(frame, { which, channel: more, count }) : null;
}

function read_path(frame: ArrayBuffer, of: OfPath): PathFrame | null {
  if (frame.byteLength < head_bytes + path_head_bytes + of.count * column_bytes) return null;
  const v = new DataView(frame),
    corner = (at: number): Triple => [v.getFloat32(at, true), v.getFloat32(at + 4, true), v.getFloat32(at + 8, true)];
  const start = v.getFloat64(start_at, true),
    columns = path_columns(frame, of.count);
  if (!Number.isFinite(start) || !all_finite(columns.at)) return null;
  return { kind: "path", ...of, start, least: corner(least_at), greatest: corner(greatest_at), ...columns };
}

function path_columns(frame: ArrayBuffer, n: number): PathColumns {
  const first = head_bytes + path_head_bytes,
    column = (i: number): number => first + 12 * n + 4 * n * i;
  return {
    kept: new Uint16Array(frame, kept_at, levels),
    at: new Float32Array(frame, first, 3 * n),
    times: new Float32Array(frame, column(0), n),
    lines: new Uint32Array(frame, column(1), n),
    numbers: new Uint32Array(frame, column(2), n),
    feeds: new Float32Array(frame, column(3), n),
    speeds: new Float32Array(frame, column(4), n),
    tools: new Uint16Array(frame, column(5), 2 * n),
    kinds: new Uint8Array(frame, column(6), 4 * n),
  };
}

function read_directions(frame: ArrayBuffer, of: OfPath): RowsFrame | null {
  if (frame.byteLength < head_bytes + 12 * of.count) return null;
  return { kind: "directions", ...of, values: new Float32Array(frame, head_bytes, 3 * of.count) };
}

/// The number of joints follows from the length.
function read_positions(frame: ArrayBuffer, of: OfPath): RowsFrame | null {
  const count = (frame.byteLength - head_bytes) / 4;
  if (count < 1 || count % of.count !== 0) return null;
  const values = new Float32Array(frame, head_bytes, count);
  return all_finite(values) ? { kind: "positions", ...of, values } : null;
}

function read_part(frame: ArrayBuffer, points: number, triangles: number): PartFrame | null {
  if (frame.byteLength < part_bytes(points, triangles)) return null;
  const part = part_columns(frame, points, triangles);
  return part.triangles.every((i) => i < points) ? part : null;
}

const part_bytes = (points: number, triangles: number): number => head_bytes + 20 * points + 12 * triangles;
function part_columns(frame: ArrayBuffer, n: number, triangles: number): PartFrame {
  const from = head_bytes + 12 * n,
    after = from + 12 * triangles;
  return {
    kind: "part",
    points: new Float32Array(frame, head_bytes, 3 * n),
    triangles: new Uint32Array(frame, from, 3 * triangles),
    made_by: new Uint16Array(frame, after, 2 * n),
    lines: new Uint32Array(frame, after + 4 * n, n),
  };
}

/// Zero times a finite value is zero, otherwise NaN.
function all_finite(values: Float32Array): boolean {
  let sum = 0;
  for (let i = 0; i < values.length; i++) sum += values[i]! * 0;
  return sum === 0;
}

/// Returns a frame of zeros with its header.
function begun(kind: keyof typeof kinds, bytes: number, which: number, count: number, more: number): ArrayBuffer {
  const frame = new ArrayBuffer(bytes);
  new Uint32Array(frame, 0, 4).set([kinds[kind], which, count, more]);
  return frame;
}

/// `first`: number of its first vertex in the path. `fill` writes all columns except `kept`, which is computed from
/// them, as the corners are.
export function write_path(
  of: OfPath & { start: number; first: number },
  fill: (columns: PathColumns) => void,
): ArrayBuffer {
  const frame = begun("path", head_bytes + path_head_bytes + of.count * column_bytes, of.which, of.count, of.channel);
  const columns = path_columns(frame, of.count),
    v = new DataView(frame);
  fill(columns);
  v.setFloat64(start_at, of.start, true);
  for (let axis = 0; axis < 3; axis++) {
    let least = Infinity,
      greatest = -Infinity;
    for (let i = axis; i < 3 * of.count; i += 3) {
      least = Math.min(least, columns.at[i]!);
      greatest = Math.max(greatest, columns.at[i]!);
    }
    v.setFloat32(least_at + 4 * axis, least, true);
    v.setFloat32(greatest_at + 4 * axis, greatest, true);
  }
  v.setUint32(first_at, of.first, true);
  v.setUint32(first_number_at, columns.numbers[0] ?? 0, true);
  for (let i = 0; i < of.count; i++)
    for (let level = 0; level <= columns.kinds[4 * i + 1]!; level++) columns.kept[level]!++;
  return frame;
}

export function write_rows(
  kind: RowsFrame["kind"],
  of: OfPath,
  each: number,
  fill: (values: Float32Array) => void,
): ArrayBuffer {
  const frame = begun(kind, head_bytes + 4 * each * of.count, of.which, of.count, of.channel);
  fill(new Float32Array(frame, head_bytes, each * of.count));
  return frame;
}

export function write_part(points: number, triangles: number, fill: (part: PartFrame) => void): ArrayBuffer {
  const frame = begun("part", part_bytes(points, triangles), 0, points, triangles);
  fill(part_columns(frame, points, triangles));
  return frame;
}
