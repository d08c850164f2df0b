// Answers questions about the path of a report as a session would: the position of the tool at an instant, its block,
// when a line was executed.
import { jump, read_frame, type PathFrame } from "../protocol/frames";
import type { Pass } from "../protocol/types";

interface Piece extends PathFrame {
  end: number;
}

export interface PathState {
  at: number;
  number: number;
  line: number;
  file: number;
  tool: number;
  feed: number;
  speed: number;
  kind: number;
  place: [number, number, number];
  left: [number, number, number]; // mm; left: distance to the end of the block's present motion
}

export class ReportPath {
  private pieces: Piece[] = [];

  constructor(frames: ArrayBuffer[]) {
    for (const frame of frames) {
      const piece = read_frame(frame);
      if (piece?.kind === "path" && piece.which === 0)
        this.pieces.push({ ...piece, end: piece.start + piece.times[piece.count - 1]! });
    }
  }

  at(instant: number): PathState | null {
    const p = this.pieces.find((x) => x.end >= instant) ?? this.pieces[this.pieces.length - 1];
    if (!p) return null;
    let i = p.times.findIndex((t) => p.start + t >= instant);
    if (i < 0) i = p.times.length - 1;
    return this.state(p, i, instant);
  }

  /// The state at the end of a block; a block without motion has the state at the end of the next block with one.
  of_block(number: number): PathState | null {
    let found: [Piece, number] | null = null;
    for (const p of this.pieces) {
      if (p.numbers[p.numbers.length - 1]! < number) continue;
      for (let i = 0; i < p.numbers.length; i++) {
        if (p.numbers[i]! < number) continue;
        if (found && p.numbers[i]! > found[0].numbers[found[1]]!)
          return this.state(...found, found[0].start + found[0].times[found[1]]!);
        found = [p, i];
      }
    }
    if (!found) {
      const last = this.pieces[this.pieces.length - 1];
      if (last) found = [last, last.numbers.length - 1];
    }
    return found && this.state(...found, found[0].start + found[0].times[found[1]]!);
  }

  /// The times at which a line was executed, up to `most` of them.
  passes(line: number, file: number, most: number): { passes: Pass[]; count: number } {
    const passes: Pass[] = [];
    let count = 0,
      last = -1;
    for (const p of this.pieces) {
      for (let i = 0; i < p.lines.length; i++) {
        if (p.lines[i] !== line || p.tools[2 * i + 1] !== file || p.kinds[4 * i] === jump) continue;
        const end = p.start + p.times[i]!;
        if (p.numbers[i] === last) {
          if (passes.length === count) passes[passes.length - 1]!.to = end;
          continue;
        }
        last = p.numbers[i]!;
        if (++count <= most) passes.push({ from: p.start + p.times[Math.max(0, i - 1)]!, to: end, number: last });
      }
    }
    return { passes, count };
  }

  private state(p: Piece, i: number, instant: number): PathState {
    const to = p.at.subarray(3 * i, 3 * i + 3),
      from = i > 0 && p.kinds[4 * i] !== jump ? p.at.subarray(3 * i - 3, 3 * i) : to;
    const begins = p.start + (i > 0 ? p.times[i - 1]! : p.times[i]!),
      ends = p.start + p.times[i]!;
    const part = ends > begins ? Math.min(1, Math.max(0, (instant - begins) / (ends - begins))) : 1;
    const place = [0, 1, 2].map((a) => from[a]! + part * (to[a]! - from[a]!)) as [number, number, number];
    return {
      at: instant,
      number: p.numbers[i]!,
      line: p.lines[i]!,
      file: p.tools[2 * i + 1]!,
      tool: p.tools[2 * i]!,
      feed: p.feeds[i]!,
      speed: instant > begins && instant <= ends ? p.speeds[i]! : 0,
      kind: p.kinds[4 * i]!,
      place,
      left: [0, 1, 2].map((a) => to[a]! - place[a]!) as [number, number, number],
    };
  }
}
