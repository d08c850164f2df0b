// The data of the path that the slider and the speed strip need: time, block and speed of every vertex, as views into
// the received frames.
import type { PathFrame } from "../protocol/frames";

interface Piece {
  start: number;
  end: number;
  times: Float32Array;
  numbers: Uint32Array;
  speeds: Float32Array;
  feeds: Float32Array;
  runs: Runs;
}

/// For every `run_length` vertices: when they end, their least and greatest speed, greatest feed. A strip of the whole
/// program reads these.
interface Runs {
  ends: Float32Array;
  least: Float32Array;
  greatest: Float32Array;
  feed: Float32Array;
}
const run_length = 64;

export interface Bins {
  at: Float64Array;
  least: Float64Array;
  greatest: Float64Array;
  feed: Float64Array;
}

export class PathIndex {
  private pieces: Piece[] = [];
  vertices = 0;

  clear(): void {
    this.pieces = [];
    this.vertices = 0;
  }

  /// Adds a piece of the program itself (`which` 0, channel 0); all other pieces are for the picture only.
  add(frame: PathFrame): void {
    if (frame.which !== 0 || frame.channel !== 0) return;
    const { start, count, times, numbers, speeds, feeds } = frame;
    this.vertices += count;
    this.pieces.push({
      start,
      end: start + times[count - 1]!,
      times,
      numbers,
      speeds,
      feeds,
      runs: runs_of(times, speeds, feeds),
    });
  }

  get seconds(): number {
    return this.pieces.length ? this.pieces[this.pieces.length - 1]!.end : 0;
  }

  /// Returns the number of the block in execution at that instant; 0 where there is no path.
  number_at(at: number): number {
    const p = this.piece_at(at);
    if (!p) return 0;
    return p.numbers[first_not_before(p.times, at - p.start)] ?? 0;
  }

  /// Returns the speed in `count` equal intervals of time, the least and greatest of each, so that no slow corner is
  /// lost between two pixels.
  bins(from: number, to: number, count: number): Bins {
    const out: Bins = {
      at: new Float64Array(count),
      least: new Float64Array(count).fill(NaN),
      greatest: new Float64Array(count).fill(NaN),
      feed: new Float64Array(count).fill(NaN),
    };
    const width = (to - from) / count;
    for (let i = 0; i < count; i++) out.at[i] = from + (i + 0.5) * width;
    if (!(width > 0)) return out;
    for (const p of this.pieces) if (p.end >= from && p.start <= to) fill_bins(out, p, from, width, count);
    return out;
  }

  private piece_at(at: number): Piece | undefined {
    let low = 0,
      high = this.pieces.length - 1;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.pieces[middle]!.end < at) low = middle + 1;
      else high = middle;
    }
    return this.pieces[low];
  }
}

/// Only motions that take time count; a run without any has a least speed above its greatest.
function runs_of(times: Float32Array, speeds: Float32Array, feeds: Float32Array): Runs {
  const n = Math.ceil((times.length - 1) / run_length),
    r: Runs = {
      ends: new Float32Array(n),
      least: new Float32Array(n).fill(Infinity),
      greatest: new Float32Array(n).fill(-Infinity),
      feed: new Float32Array(n),
    };
  for (let i = 1; i < times.length; i++) {
    const k = Math.floor((i - 1) / run_length);
    r.ends[k] = times[i]!;
    if (!(times[i]! > times[i - 1]!)) continue;
    if (speeds[i]! < r.least[k]!) r.least[k] = speeds[i]!;
    if (speeds[i]! > r.greatest[k]!) r.greatest[k] = speeds[i]!;
    if (feeds[i]! > r.feed[k]!) r.feed[k] = feeds[i]!;
  }
  return r;
}

function fill_bins(out: Bins, p: Piece, from: number, width: number, count: number): void {
  const bin = (at: number): number => Math.floor((at - from) / width);
  let before = p.start + p.times[0]!;
  for (let k = 0; k < p.runs.ends.length; k++) {
    const end = p.start + p.runs.ends[k]!,
      a = bin(before);
    if (a !== bin(end)) fill_run(out, p, k, from, width, count);
    else if (a >= 0 && a < count) widen(out, a, p.runs.least[k]!, p.runs.greatest[k]!, p.runs.feed[k]!);
    before = end;
  }
}

function fill_run(out: Bins, p: Piece, run: number, from: number, width: number, count: number): void {
  const first = 1 + run * run_length,
    last = Math.min(p.times.length - 1, first + run_length - 1);
  let before = p.start + p.times[first - 1]!;
  for (let i = first; i <= last; i++) {
    const end = p.start + p.times[i]!;
    const a = Math.max(0, Math.floor((before - from) / width)),
      b = Math.min(count - 1, Math.floor((end - from) / width));
    if (end > before) for (let k = a; k <= b; k++) widen(out, k, p.speeds[i]!, p.speeds[i]!, p.feeds[i]!);
    before = end;
  }
}

function widen(out: Bins, k: number, least: number, greatest: number, feed: number): void {
  if (least > greatest) return;
  if (!(out.least[k]! <= least)) out.least[k] = least;
  if (!(out.greatest[k]! >= greatest)) out.greatest[k] = greatest;
  if (feed > 0 && !(out.feed[k]! >= feed)) out.feed[k] = feed;
}

/// Returns the index of the first value that is not below `what`; the last index if all are below.
export function first_not_before(times: Float32Array, what: number): number {
  let low = 0,
    high = times.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! < what) low = middle + 1;
    else high = middle;
  }
  return low;
}
