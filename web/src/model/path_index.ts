// What the slider and the speed strip need of the path: time, block and speed of every vertex, in pieces as they came. Twelve bytes a vertex.
import { path_columns, head_of } from "../protocol/frames";

interface Piece { start: number; end: number; times: Float32Array; numbers: Uint32Array; speeds: Float32Array; feeds: Float32Array }

export interface Bins { at: Float64Array; least: Float64Array; greatest: Float64Array; feed: Float64Array }

export class PathIndex {
  private pieces: Piece[] = [];
  vertices = 0;

  clear(): void { this.pieces = []; this.vertices = 0; }

  /// Takes pieces of the program itself (`which` 0, channel 0); all else is for the picture only.
  add(frame: ArrayBuffer): void {
    const head = head_of(frame);
    if (!head || head.which !== 0 || head.more !== 0) return;
    const c = path_columns(frame);
    if (!c || head.count === 0) return;
    this.vertices += head.count;
    this.pieces.push({
      start: c.start, end: c.start + c.times[head.count - 1]!,
      times: c.times.slice(), numbers: c.numbers.slice(), speeds: c.speeds.slice(), feeds: c.feeds.slice(),
    });
  }

  get seconds(): number { return this.pieces.length ? this.pieces[this.pieces.length - 1]!.end : 0; }

  /// Number of the block that is under way at that instant; 0 where there is no path.
  number_at(at: number): number {
    const p = this.piece_at(at);
    if (!p) return 0;
    return p.numbers[first_not_before(p.times, at - p.start)] ?? 0;
  }

  /// The speed in `count` equal stretches of time, least and greatest of each, so that no slow corner is lost between two pixels.
  bins(from: number, to: number, count: number): Bins {
    const out: Bins = { at: new Float64Array(count), least: new Float64Array(count).fill(NaN), greatest: new Float64Array(count).fill(NaN), feed: new Float64Array(count).fill(NaN) };
    const width = (to - from) / count;
    for (let i = 0; i < count; i++) out.at[i] = from + (i + 0.5) * width;
    if (!(width > 0)) return out;
    for (const p of this.pieces) if (p.end >= from && p.start <= to) fill_bins(out, p, from, width, count);
    return out;
  }

  private piece_at(at: number): Piece | undefined {
    let low = 0, high = this.pieces.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.pieces[middle]!.end < at) low = middle + 1; else high = middle;
    }
    return this.pieces[low];
  }
}

function fill_bins(out: Bins, p: Piece, from: number, width: number, count: number): void {
  let before = p.start + p.times[0]!;
  for (let i = 1; i < p.times.length; i++) {
    const end = p.start + p.times[i]!, speed = p.speeds[i]!, feed = p.feeds[i]!;
    const a = Math.max(0, Math.floor((before - from) / width)), b = Math.min(count - 1, Math.floor((end - from) / width));
    if (end > before) {
      for (let k = a; k <= b; k++) {
        if (!(out.least[k]! <= speed)) out.least[k] = speed;
        if (!(out.greatest[k]! >= speed)) out.greatest[k] = speed;
        if (feed > 0 && !(out.feed[k]! >= feed)) out.feed[k] = feed;
      }
    }
    before = end;
  }
}

/// Index of the first value that is not below `what`; the last one where all are.
export function first_not_before(times: Float32Array, what: number): number {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! < what) low = middle + 1; else high = middle;
  }
  return low;
}
