// Arithmetic of the time slider: positions on the bar, the next mark, playing.
import type { Mark } from "../protocol/types";

export const clamp = (v: number, low: number, high: number): number => Math.min(Math.max(v, low), high);

/// Converts an instant to a position on a bar `width` wide.
export function place_of(at: number, width: number, seconds: number): number {
  return seconds > 0 ? clamp(at / seconds, 0, 1) * width : 0;
}

const same_instant = 1e-4; // s: below the rounding of a float for a time within a day

/// Returns the nearest mark of these kinds after (`way` 1) or before (−1) an instant; null if there is none.
export function next_mark(marks: Mark[], kinds: string[], at: number, way: 1 | -1): Mark | null {
  let best: Mark | null = null;
  for (const m of marks) {
    if (!kinds.includes(m.kind) || (m.at - at) * way <= same_instant) continue;
    if (!best || (m.at - best.at) * way < 0) best = m;
  }
  return best;
}

/// One picture of playing: returns the instant after `ms` of wall-clock time. In a loop it starts again after the end.
export function played(at: number, ms: number, times: number, seconds: number, loop: [number, number] | null): number {
  const next = at + (ms / 1000) * times;
  if (loop && next >= loop[1]) return loop[0];
  return clamp(next, 0, seconds);
}

/// The speed slider is logarithmic: 0 … 1 gives 0.1 … 1000.
export const times_of = (slider: number): number => Number((10 ** (slider * 4 - 1)).toPrecision(2));
export const slider_of = (times: number): number => (Math.log10(times) + 1) / 4;

/// Marks on the same pixels become one, with the most severe of their kinds.
export interface Cluster {
  at: number;
  marks: Mark[];
  kind: Mark["kind"];
}
const grave: Mark["kind"][] = ["alarm", "warning", "stop", "tool", "end", "optional_stop", "zero", "message", "dwell"];
/// `from`: the instant at the left end of the bar.
export function clusters(marks: Mark[], seconds: number, width: number, apart = 5, from = 0): Cluster[] {
  const out: Cluster[] = [];
  for (const m of [...marks].sort((a, b) => a.at - b.at)) {
    const last = out[out.length - 1];
    if (last && place_of(m.at - from, width, seconds) - place_of(last.at - from, width, seconds) < apart) {
      last.marks.push(m);
      if (grave.indexOf(m.kind) < grave.indexOf(last.kind)) last.kind = m.kind;
    } else out.push({ at: m.at, marks: [m], kind: m.kind });
  }
  return out;
}
