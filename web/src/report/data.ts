// The contents of a report (docs/panel-protocol.md, A report): JSON, and pieces of path and part as packed columns.
// They become the frames that a session would have sent.
import { write_part, write_path, write_rows } from "../protocol/frames";
import type { TurnedSection } from "../scene/section";
import type { CutResult, Done, Finding, Language, Opened, Problem, Sheet } from "../protocol/types";

/// Texts in one language.
export interface Told {
  opened: Opened;
  done: Done;
  problems: Problem[];
  sheet: Sheet;
  findings: Finding[];
  cut: CutResult | null;
}
export interface ReportData {
  version: string;
  made: string;
  file: string;
  language: Language;
  quanta: { length: number; time: number; feed: number; direction: number; position: number };
  sources: { file: number; name: string; text: string }[];
  thinned: number;
  licences: string;
  en: Told;
  ru: Told;
  part: ({ cell: number; off: number } & Partial<TurnedSection>) | null;
}
export interface Report {
  data: ReportData;
  path: ArrayBuffer[];
  part: ArrayBuffer | null;
}

const path_kind = 1,
  part_kind = 3;

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
    const kind = view.getUint32(at, true),
      size = view.getUint32(at + 4, true);
    const piece = new Columns(bytes, at + 8);
    if (kind === path_kind) report.path.push(...path_frames(piece, data));
    else if (kind === part_kind) report.part = part_frame(piece, data);
    at += 8 + size;
  }
  return report;
}

/// Columns of differences: the lowest bytes of all values first, then the next ones. The sign is the lowest bit.
class Columns {
  private bytes: Uint8Array;
  private view: DataView;
  constructor(
    buffer: ArrayBuffer,
    private at: number,
  ) {
    this.bytes = new Uint8Array(buffer);
    this.view = new DataView(buffer);
  }
  u32(): number {
    this.at += 4;
    return this.view.getUint32(this.at - 4, true);
  }
  f64(): number {
    this.at += 8;
    return this.view.getFloat64(this.at - 8, true);
  }
  ints(count: number): Int32Array {
    const out = new Int32Array(count),
      b = this.bytes,
      at = this.at;
    let value = 0;
    for (let i = 0; i < count; i++) {
      const z =
        b[at + i]! | (b[at + count + i]! << 8) | (b[at + 2 * count + i]! << 16) | (b[at + 3 * count + i]! << 24);
      value = (value + ((z >>> 1) ^ -(z & 1))) | 0;
      out[i] = value;
    }
    this.at += 4 * count;
    return out;
  }
}

function path_frames(c: Columns, data: ReportData): ArrayBuffer[] {
  const q = data.quanta,
    count = c.u32(),
    which = c.u32(),
    channel = c.u32(),
    besides = c.u32(),
    first = c.u32(),
    start = c.f64(),
    of = { which, channel, count };
  const frames = [
    write_path({ ...of, start, first }, (p) => {
      put(c, p.at, 3, q.length);
      put(c, p.times, 1, q.time);
      put(c, p.lines, 1);
      put(c, p.numbers, 1);
      put(c, p.feeds, 1, q.feed);
      put(c, p.speeds, 1, q.feed);
      put(c, p.tools, 2);
      put(c, p.kinds, 2, 1, 4);
    }),
  ];
  const leans = besides & 1,
    joints = besides >>> 1; // the directions first
  if (leans) frames.push(write_rows("directions", of, 3, (values) => put(c, values, 3, q.direction)));
  if (joints) frames.push(write_rows("positions", of, joints, (values) => put(c, values, joints, q.position)));
  return frames;
}

function part_frame(c: Columns, data: ReportData): ArrayBuffer {
  const points = c.u32(),
    triangles = c.u32();
  return write_part(points, triangles, (part) => {
    put(c, part.points, 3, data.quanta.length);
    part.triangles.set(c.ints(3 * triangles));
    put(c, part.made_by, 1, 1, 2);
    put(c, part.lines, 1);
  });
}

/// Writes the next `columns` columns into rows of `each` values in `to`, as the first values of each row.
function put(
  c: Columns,
  to: Float32Array | Uint32Array | Uint16Array | Uint8Array,
  columns: number,
  unit = 1,
  each = columns,
): void {
  for (let k = 0; k < columns; k++)
    c.ints(to.length / each).forEach((value, i) => {
      to[each * i + k] = value * unit;
    });
}
