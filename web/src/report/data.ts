// What a report holds (docs/panel-protocol.md, A report): JSON, and pieces of path and part as packed columns. Here they become the frames that
// a session would have sent.
import { frame_directions, frame_part, frame_path, frame_positions } from "../protocol/frames";
import type { CutResult, Done, Finding, Language, Opened, Problem, Sheet } from "../protocol/types";

/// Texts in one language.
export interface Told { opened: Opened; done: Done; problems: Problem[]; sheet: Sheet; findings: Finding[]; cut: CutResult | null }
export interface ReportData {
  version: string; made: string; file: string; language: Language; quanta: { length: number; time: number; feed: number; direction: number; position: number };
  sources: { file: number; name: string; text: string }[]; thinned: number; licences: string; en: Told; ru: Told;
  part: { cell: number; off: number } | null;
}
export interface Report { data: ReportData; path: ArrayBuffer[]; part: ArrayBuffer | null }

const path_kind = 1, part_kind = 3;

/// `text`: base64 of a zlib stream.
export async function unpack(text: string): Promise<Report> {
  const packed = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return read(await new Response(stream).arrayBuffer());
}

export function read(bytes: ArrayBuffer): Report {
  const view = new DataView(bytes);
  const length = view.getUint32(0, true);
  const data = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))) as ReportData;
  const report: Report = { data, path: [], part: null };
  for (let at = 4 + length; at + 8 <= bytes.byteLength;) {
    const kind = view.getUint32(at, true), size = view.getUint32(at + 4, true);
    const piece = new Columns(bytes, at + 8);
    if (kind === path_kind) report.path.push(...path_frames(piece, data));
    else if (kind === part_kind) report.part = part_frame(piece, data);
    at += 8 + size;
  }
  return report;
}

/// Columns of differences: of each the least bytes of all values, then the next ones. The sign stands in the lowest bit.
class Columns {
  private bytes: Uint8Array;
  private view: DataView;
  constructor(buffer: ArrayBuffer, private at: number) {
    this.bytes = new Uint8Array(buffer);
    this.view = new DataView(buffer);
  }
  u32(): number { this.at += 4; return this.view.getUint32(this.at - 4, true); }
  f64(): number { this.at += 8; return this.view.getFloat64(this.at - 8, true); }
  ints(count: number): Int32Array {
    const out = new Int32Array(count), b = this.bytes, at = this.at;
    let value = 0;
    for (let i = 0; i < count; i++) {
      const z = b[at + i]! | (b[at + count + i]! << 8) | (b[at + 2 * count + i]! << 16) | (b[at + 3 * count + i]! << 24);
      value = (value + ((z >>> 1) ^ -(z & 1))) | 0;
      out[i] = value;
    }
    this.at += 4 * count;
    return out;
  }
}

function path_frames(c: Columns, data: ReportData): ArrayBuffer[] {
  const q = data.quanta, count = c.u32(), which = c.u32(), channel = c.u32(), besides = c.u32(), first = c.u32(), begins = c.f64();
  const xyz = [c.ints(count), c.ints(count), c.ints(count)], time = c.ints(count), line = c.ints(count), number = c.ints(count);
  const feed = c.ints(count), speed = c.ints(count), tool = c.ints(count), file = c.ints(count), kind = c.ints(count), level = c.ints(count);
  const frame = new ArrayBuffer(16 + 80 + 40 * count), view = new DataView(frame);
  [frame_path, which, count, channel].forEach((v, i) => view.setUint32(4 * i, v, true));
  view.setFloat64(16, begins, true);
  xyz.forEach((column, axis) => {
    let least = Infinity, most = -Infinity;
    for (const v of column) { least = Math.min(least, v); most = Math.max(most, v); }
    view.setFloat32(24 + 4 * axis, least * q.length, true);
    view.setFloat32(36 + 4 * axis, most * q.length, true);
  });
  view.setUint32(48, first, true);
  view.setUint32(52, number[0] ?? 0, true);
  for (let l = 0; l < 16; l++) view.setUint16(56 + 2 * l, level.reduce((n, v) => n + Number(v >= l), 0), true);
  let at = 96;
  const column = (put: (i: number) => void): void => { for (let i = 0; i < count; i++, at += 4) put(i); };
  for (let i = 0; i < count; i++) for (let a = 0; a < 3; a++, at += 4) view.setFloat32(at, xyz[a]![i]! * q.length, true);
  column((i) => view.setFloat32(at, time[i]! * q.time, true));
  column((i) => view.setUint32(at, line[i]! >>> 0, true));
  column((i) => view.setUint32(at, number[i]! >>> 0, true));
  column((i) => view.setFloat32(at, feed[i]! * q.feed, true));
  column((i) => view.setFloat32(at, speed[i]! * q.feed, true));
  column((i) => { view.setUint16(at, tool[i]!, true); view.setUint16(at + 2, file[i]!, true); });
  column((i) => { view.setUint8(at, kind[i]!); view.setUint8(at + 1, level[i]!); });
  const leans = besides & 1, joints = besides >>> 1, frames = [frame]; // the directions first
  if (leans) frames.push(rows_frame(c, frame_directions, [which, count, channel], 3, q.direction));
  if (joints) frames.push(rows_frame(c, frame_positions, [which, count, channel], joints, q.position));
  return frames;
}

/// As many columns become rows.
function rows_frame(c: Columns, kind: number, head: [which: number, count: number, channel: number], each: number, unit: number): ArrayBuffer {
  const count = head[1], columns = Array.from({ length: each }, () => c.ints(count));
  const frame = new ArrayBuffer(16 + 4 * each * count), view = new DataView(frame);
  [kind, ...head].forEach((v, i) => view.setUint32(4 * i, v, true));
  for (let i = 0; i < count; i++) for (let a = 0; a < each; a++) view.setFloat32(16 + 4 * (each * i + a), columns[a]![i]! * unit, true);
  return frame;
}

function part_frame(c: Columns, data: ReportData): ArrayBuffer {
  const count = c.u32(), triangles = c.u32();
  const xyz = [c.ints(count), c.ints(count), c.ints(count)], corners = c.ints(3 * triangles), tool = c.ints(count), line = c.ints(count);
  const frame = new ArrayBuffer(16 + 12 * count + 12 * triangles + 8 * count), view = new DataView(frame);
  [frame_part, 0, count, triangles].forEach((v, i) => view.setUint32(4 * i, v, true));
  let at = 16;
  for (let i = 0; i < count; i++) for (let a = 0; a < 3; a++, at += 4) view.setFloat32(at, xyz[a]![i]! * data.quanta.length, true);
  for (const corner of corners) { view.setUint32(at, corner, true); at += 4; }
  for (let i = 0; i < count; i++, at += 4) view.setUint16(at, tool[i]!, true);
  for (let i = 0; i < count; i++, at += 4) view.setUint32(at, line[i]! >>> 0, true);
  return frame;
}
