// The part of the machine time that slider and speed strip show: all of it, or what the user has zoomed to.
import { Signal } from "./signal";
import { clamp } from "./time";

const shortest = 0.05; // s

export class TimeWindow {
  readonly on_change = new Signal<void>();
  private part: [number, number] = [0, 1]; // of all the time

  constructor(private all: () => number) {}

  get from(): number {
    return this.part[0] * this.all();
  }
  get seconds(): number {
    return (this.part[1] - this.part[0]) * this.all();
  }
  get is_whole(): boolean {
    return this.part[0] <= 0 && this.part[1] >= 1;
  }

  /// Converts an instant to its share of the width, and back; 0 … 1 is visible.
  share_of(at: number): number {
    return this.seconds > 0 ? (at - this.from) / this.seconds : 0;
  }
  instant_at(share: number): number {
    return this.from + clamp(share, 0, 1) * this.seconds;
  }

  show_all(): void {
    this.set(0, 1);
  }
  /// Shows `times` as much of the time; the instant `at` keeps its place.
  zoom(times: number, at: number): void {
    const all = this.all();
    if (!(all > 0)) return;
    const width = this.part[1] - this.part[0],
      wanted = clamp(width * times, Math.min(1, shortest / all), 1),
      here = clamp(at / all, this.part[0], this.part[1]),
      begin = here - ((here - this.part[0]) / width) * wanted;
    this.set(begin, begin + wanted);
  }
  move(share: number): void {
    const width = this.part[1] - this.part[0];
    this.set(this.part[0] + share * width, this.part[1] + share * width);
  }
  /// Moves so that the instant is visible.
  follow(at: number): void {
    const share = this.share_of(at);
    if (share < 0 || share > 1) this.move(share - (share < 0 ? 0.9 : 0.1));
  }

  private set(from: number, to: number): void {
    const width = Math.min(1, to - from),
      begin = clamp(from, 0, 1 - width);
    if (begin === this.part[0] && begin + width === this.part[1]) return;
    this.part = [begin, begin + width];
    this.on_change.emit();
  }
}

/// The top of the strip's scale: the greatest value, unless it is far above nearly all others. One wrong feed would
/// flatten everything else.
export function top_of(values: ArrayLike<number>): number {
  const known = Array.from(values)
    .filter((v) => v > 0)
    .sort((a, b) => a - b);
  if (!known.length) return 1;
  const greatest = known[known.length - 1]!,
    usual = known[Math.floor(0.95 * (known.length - 1))]!,
    far = 4;
  return greatest > far * usual ? usual * 1.5 : greatest;
}
