// The motion nearest to the pointer: measured on the screen, over what is drawn. Of two as near, the one in front.
import { Matrix4 } from "three";
import type { Eye } from "./camera";
import type { Piece } from "./frame";
import type { Drawn } from "./path_view";
import type { Point, SceneVertex } from "./types";

export interface Hit { vertex: SceneVertex; place: Point } // place: on the segment, at its end where the pointer is near that

const reach = 8, snap = 9; // pixels: how far the pointer may be off a line, and off a corner to snap to it

interface Best { off: number; depth: number; d: Drawn | null; segment: number; part: number; length: number }

export function pick(all: readonly Drawn[], eye: Eye, x: number, y: number, width: number, height: number, zero: Point): Hit | null {
  const m = new Matrix4().multiplyMatrices(eye.camera.projectionMatrix, eye.camera.matrixWorldInverse).elements;
  const best: Best = { off: reach, depth: Infinity, d: null, segment: 0, part: 0, length: 0 };
  for (const d of all) if (d.lines.visible) nearest_of(d, m, x, y, width, height, best);
  return best.d && hit_of(best.d, best, zero);
}

function nearest_of(d: Drawn, m: readonly number[], x: number, y: number, width: number, height: number, best: Best): void {
  const { points, ends } = d.segments;
  const px = [0, 0], py = [0, 0], pz = [0, 0];
  for (let s = d.lines.geometry.drawRange.start / 2; s < ends.length; s++) {
    for (let e = 0; e < 2; e++) {
      const i = 6 * s + 3 * e, a = points[i]!, b = points[i + 1]!, c = points[i + 2]!;
      const w = m[3]! * a + m[7]! * b + m[11]! * c + m[15]!;
      px[e] = ((m[0]! * a + m[4]! * b + m[8]! * c + m[12]!) / w + 1) * 0.5 * width;
      py[e] = (1 - (m[1]! * a + m[5]! * b + m[9]! * c + m[13]!) / w) * 0.5 * height;
      pz[e] = (m[2]! * a + m[6]! * b + m[10]! * c + m[14]!) / w;
    }
    const dx = px[1]! - px[0]!, dy = py[1]! - py[0]!, square = dx * dx + dy * dy;
    const part = square > 0 ? Math.min(1, Math.max(0, ((x - px[0]!) * dx + (y - py[0]!) * dy) / square)) : 1;
    const off = Math.hypot(px[0]! + part * dx - x, py[0]! + part * dy - y), depth = pz[0]! + part * (pz[1]! - pz[0]!);
    if (off < best.off - 0.5 || (off < best.off + 0.5 && off < reach && depth < best.depth))
      Object.assign(best, { off, depth, d, segment: s, part, length: Math.sqrt(square) });
  }
}

function hit_of(d: Drawn, best: Best, zero: Point): Hit {
  const { segment: s, length } = best, p = d.segments.points;
  const part = (1 - best.part) * length < snap ? 1 : best.part * length < snap ? 0 : best.part;
  const on = (k: number): number => p[6 * s + k]! + part * (p[6 * s + 3 + k]! - p[6 * s + k]!);
  return { vertex: vertex_of(d.piece, d.segments.ends[s]!, zero), place: [on(0), on(1), on(2)] };
}

export function vertex_of(p: Piece, i: number, zero: Point): SceneVertex {
  const at = (k: number): Point => [p.at[3 * k]! - zero[0], p.at[3 * k + 1]! - zero[1], p.at[3 * k + 2]! - zero[2]];
  return {
    which: p.which, at: at(i), time: p.start + p.times[i]!, line: p.lines[i]!, file: p.tools[2 * i + 1]!, number: p.numbers[i]!,
    kind: p.kinds[4 * i]!, tool: p.tools[2 * i]!, feed: p.feeds[i]!, speed: p.speeds[i]!, radius: radius_at(p, i, at),
  };
}

/// Of an arc: the circle through three of its vertices, seen along Z, where a helix is a circle too.
function radius_at(p: Piece, i: number, at: (k: number) => Point): number | undefined {
  const kind = p.kinds[4 * i]!;
  if (kind !== 3 && kind !== 4) return undefined;
  const same = (k: number): boolean => k > 0 && k < p.count && p.numbers[k] === p.numbers[i] && p.kinds[4 * k] === kind;
  let first = i, last = i;
  while (same(first)) first--;
  while (same(last + 1)) last++;
  if (last - first < 2) return undefined;
  const middle = first + Math.max(1, Math.min(last - first - 1, i - first));
  return circle(at(middle - 1), at(middle), at(middle + 1));
}

/// Radius of the circle through three points: product of the sides over four times the area.
export function circle(a: Point, b: Point, c: Point): number | undefined {
  const side = (p: Point, q: Point): number => Math.hypot(p[0] - q[0], p[1] - q[1]);
  const area = Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
  const radius = (side(a, b) * side(b, c) * side(c, a)) / (4 * area);
  return Number.isFinite(radius) && area > 1e-9 ? radius : undefined;
}
