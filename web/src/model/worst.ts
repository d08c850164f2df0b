// Where the machine loses most time compared with the programmed feed: by line, from the received path. Causes are
// starts, corners, short motions.
import { jump, type OfPathFrame } from "../protocol/frames";

export interface WorstLine {
  line: number;
  file: number;
  lost: number;
  seconds: number;
  feed: number;
  least: number;
  at: number;
} // s, mm/min; `at`: the instant of the greatest single loss

export class WorstLines {
  private by_line = new Map<number, WorstLine & { greatest: number }>();

  clear(): void {
    this.by_line.clear();
  }

  /// Adds a piece of the program's own path.
  add(c: OfPathFrame): void {
    if (c.kind !== "path" || c.which !== 0 || c.channel !== 0) return;
    for (let i = 1; i < c.count; i++) {
      const feed = c.feeds[i]!,
        speed = c.speeds[i]!,
        seconds = c.times[i]! - c.times[i - 1]!;
      if (!(feed > 0) || !(seconds > 0) || c.kinds[4 * i] === jump || !(speed < feed)) continue;
      this.take(c.lines[i]!, c.tools[2 * i + 1]!, {
        seconds,
        lost: seconds * (1 - speed / feed),
        feed,
        least: speed,
        at: c.start + c.times[i - 1]!,
      });
    }
  }

  /// The greatest losses first; none below `least` s.
  worst(count: number, least = 0.05): WorstLine[] {
    return [...this.by_line.values()]
      .filter((w) => w.lost >= least)
      .sort((a, b) => b.lost - a.lost || a.line - b.line)
      .slice(0, count);
  }

  private take(
    line: number,
    file: number,
    one: { seconds: number; lost: number; feed: number; least: number; at: number },
  ): void {
    const key = file * 2 ** 32 + line,
      known = this.by_line.get(key);
    if (!known) {
      this.by_line.set(key, { line, file, ...one, greatest: one.lost });
      return;
    }
    known.lost += one.lost;
    known.seconds += one.seconds;
    known.least = Math.min(known.least, one.least);
    if (one.lost > known.greatest) {
      known.greatest = one.lost;
      known.at = one.at;
      known.feed = one.feed;
    }
  }
}
