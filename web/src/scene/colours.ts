// The colour of each motion, as four bytes. Rapids are dim in every colouring, because the cutting motions are of
// interest.
import { is_rapid } from "../protocol/frames";
import type { Piece } from "./frame";
import type { ColourBy } from "./types";

export type Rgba = [number, number, number, number];
export interface Theme {
  ground: number;
  rapid: Rgba;
  kinds: Rgba[];
  other: Rgba;
  programmed: Rgba;
  bright: number;
  stock: number;
  extents: number;
  limits: number;
  zone: number;
  over: number;
  part: number;
  cut_part: number;
  tool: number;
  holder: number;
  section: number; // cut face of a turned part
  ink: number; // its lines
}

const opaque = (hex: number): Rgba => [hex >> 16, (hex >> 8) & 255, hex & 255, 255];
const kinds = (...hex: number[]): Rgba[] => hex.map(opaque); // by kind: jump, rapid, feed, arc cw, arc ccw, probe, home, thread, spline
export const light: Theme = {
  ground: 0xffffff,
  rapid: [110, 118, 130, 110],
  kinds: kinds(0x888888, 0x888888, 0x0b62d6, 0x0a7d55, 0x7b3fc4, 0xb35900, 0x888888, 0xb0186b, 0x00758f),
  other: [200, 40, 40, 200],
  programmed: [150, 120, 20, 200],
  bright: 0xe65c00,
  stock: 0x8a6d3b,
  extents: 0x9aa3ad,
  limits: 0x5b6670,
  zone: 0xb5179e,
  over: 0xd0021b,
  part: 0xaeb7c2,
  cut_part: 0x8fb3dd,
  tool: 0xd08a1d,
  holder: 0x6b7480,
  section: 0xe3e8ee,
  ink: 0x1d242d,
};
export const dark: Theme = {
  ground: 0x10151c,
  rapid: [150, 160, 172, 90],
  kinds: kinds(0x888888, 0x888888, 0x5aa2ff, 0x57c785, 0xb98cff, 0xe59b4a, 0x888888, 0xff7bbd, 0x4fd0e8),
  other: [255, 110, 110, 210],
  programmed: [220, 190, 90, 200],
  bright: 0xffb000,
  stock: 0xb89a62,
  extents: 0x59636e,
  limits: 0x8d98a4,
  zone: 0xe06bd0,
  over: 0xff6b6b,
  part: 0x7f8a97,
  cut_part: 0x5b86ba,
  tool: 0xf0b24a,
  holder: 0x8b95a1,
  section: 0x2b3644,
  ink: 0xdde5ee,
};
export const by_tool = [0x0b7ad6, 0xd2691e, 0x2e9e5b, 0xa44bd0, 0xc93a55, 0x1a9aa8, 0x9a8a12, 0x7a6a5a].map(opaque);
export const colour_of_tool = (tool: number): Rgba => by_tool[tool % by_tool.length]!;

export type Range = [number, number];
export interface Ranges {
  feed: Range;
  speed: Range;
  slowed: Range;
  time: Range;
  depth: Range;
}
export type RampBy = keyof Ranges;
export const is_ramp = (by: ColourBy): by is RampBy => by !== "kind" && by !== "tool";
export const no_ranges = (): Ranges => ({
  feed: [Infinity, -Infinity],
  speed: [Infinity, -Infinity],
  slowed: [Infinity, -Infinity],
  time: [Infinity, -Infinity],
  depth: [Infinity, -Infinity],
});

/// The least and greatest value of each quantity over the whole path: the ends of the colour ramp.
export function ranges_of(pieces: readonly Piece[]): Ranges {
  const r = no_ranges();
  for (const p of pieces) widen_ranges(r, p);
  return r;
}

export function widen_ranges(r: Ranges, p: Piece): void {
  const widen = (to: Range, from: readonly [number, number]): void => {
    to[0] = Math.min(to[0], from[0]);
    to[1] = Math.max(to[1], from[1]);
  };
  widen(r.feed, p.feed_range);
  widen(r.speed, p.speed_range);
  r.slowed = [0, 100];
  widen(r.time, [p.start, p.start + p.times[p.count - 1]!]);
  if (p.cut) widen(r.depth, [p.cut[0][2], p.cut[1][2]]);
}

/// Returns the colour of the motion that ends at a vertex of `p`: red in the lowest byte.
export function painter(p: Piece, by: ColourBy, r: Ranges, theme: Theme): (i: number) => number {
  const dim = packed(theme.rapid),
    cuts = cutting_painter(p, by, r, theme);
  return (i) => (is_rapid(p.kinds[4 * i]!) ? dim : cuts(i));
}

function cutting_painter(p: Piece, by: ColourBy, r: Ranges, theme: Theme): (i: number) => number {
  const other = packed(theme.other),
    programmed = packed(theme.programmed);
  if (p.which & 1) return () => other;
  if (p.which & 2) return () => programmed;
  if (by === "kind") {
    const all = theme.kinds.map(packed),
      last = all.length - 1;
    return (i) => all[Math.min(p.kinds[4 * i]!, last)]!;
  }
  if (by === "tool") {
    const all = by_tool.map(packed);
    return (i) => all[p.tools[2 * i]! % all.length]!;
  }
  const [low, high] = r[by],
    shades = shade_table(),
    each = high > low ? (steps - 1) / (high - low) : 0;
  const shade = (v: number): number => shades[Math.min(steps - 1, Math.max(0, Math.round((v - low) * each)))]!;
  switch (by) {
    case "feed":
      return (i) => shade(p.feeds[i]!);
    case "speed":
      return (i) => shade(p.speeds[i]!);
    case "slowed":
      return (i) => shade(slowed(p.feeds[i]!, p.speeds[i]!));
    case "time":
      return (i) => shade(p.start + p.times[i]!);
    case "depth":
      return (i) => shade(p.at[3 * i + 2]!);
  }
}

/// Returns the percentage of the feed that a limit of the machine prevents: corners, acceleration, speeds of axes.
export const slowed = (feed: number, speed: number): number => (feed > speed ? 100 * (1 - speed / feed) : 0);

export const packed = (c: Rgba): number => (c[0] | (c[1] << 8) | (c[2] << 16) | (c[3] << 24)) >>> 0;

// From low to high: blue, green, amber, red; all dark enough for a white background and light enough for black.
const stops = [0x2f6fe0, 0x12a07a, 0xd09a10, 0xd93a2b].map(opaque);
const steps = 1024; // of the table: finer than a byte of any colour
let shades: Uint32Array | null = null;
const shade_table = (): Uint32Array =>
  (shades ??= Uint32Array.from({ length: steps }, (_, i) => packed(ramp(i, [0, steps - 1]))));

export function ramp(value: number, [low, high]: readonly [number, number]): Rgba {
  const part = high > low ? Math.min(1, Math.max(0, (value - low) / (high - low))) : 0;
  const at = part * (stops.length - 1),
    i = Math.min(stops.length - 2, Math.floor(at)),
    a = stops[i]!,
    b = stops[i + 1]!;
  const mix = (k: 0 | 1 | 2): number => Math.round(a[k] + (at - i) * (b[k] - a[k]));
  return [mix(0), mix(1), mix(2), 255];
}
