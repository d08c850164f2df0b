// The motion nearest to the pointer: measured on the screen, over what is drawn, then among the motions that the drawn
// line represents. Of two at the same distance, the one in front.
import { Box3, Matrix4, Vector3 } from "three";
import { is_arc, jump, spline } from "../protocol/frames";
import { arc_at, minus } from "./arc";
import type { Eye } from "./camera";
import type { Piece } from "./frame";
import type { Drawn } from "./built_lines";
import { anchor_of } from "./measure";
import type { Anchor, Point, SceneVertex } from "./types";

export interface Hit {
  vertex: SceneVertex;
  place: Point;
  anchor: Anchor;
} // place: on the segment, or its end if the pointer is near that; relative to the picture's zero

const reach = 8,
  snap = 9; // pixels: greatest distance of the pointer from a line, and from a corner to snap to it

interface Best {
  off: number;
  depth: number;
  d: Drawn | null;
  segment: number;
  part: number;
  length: number;
}

/// From machine coordinates to pixels of the screen.
class Screen {
  private m: readonly number[];
  constructor(
    eye: Eye,
    zero: Point,
    private x: number,
    private y: number,
    private width: number,
    private height: number,
  ) {
    this.m = new Matrix4()
      .multiplyMatrices(eye.camera.projectionMatrix, eye.camera.matrixWorldInverse)
      .multiply(new Matrix4().makeTranslation(-zero[0], -zero[1], -zero[2])).elements;
  }

  /// Tests the motion between two points, three numbers each of `points`.
  near(points: Float32Array, from: number, to: number, best: Best, d: Drawn, segment: number): void {
    const { m, width, height, x, y } = this;
    const a = points[from]!,
      b = points[from + 1]!,
      c = points[from + 2]!,
      e = points[to]!,
      f = points[to + 1]!,
      g = points[to + 2]!;
    const w0 = m[3]! * a + m[7]! * b + m[11]! * c + m[15]!,
      w1 = m[3]! * e + m[7]! * f + m[11]! * g + m[15]!;
    const x0 = ((m[0]! * a + m[4]! * b + m[8]! * c + m[12]!) / w0 + 1) * 0.5 * width,
      y0 = (1 - (m[1]! * a + m[5]! * b + m[9]! * c + m[13]!) / w0) * 0.5 * height;
    const x1 = ((m[0]! * e + m[4]! * f + m[8]! * g + m[12]!) / w1 + 1) * 0.5 * width,
      y1 = (1 - (m[1]! * e + m[5]! * f + m[9]! * g + m[13]!) / w1) * 0.5 * height;
    const dx = x1 - x0,
      dy = y1 - y0,
      square = dx * dx + dy * dy;
    const part = square > 0 ? Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / square)) : 1;
    const off = Math.hypot(x0 + part * dx - x, y0 + part * dy - y);
    if (off > best.off + 0.5) return;
    const z0 = (m[2]! * a + m[6]! * b + m[10]! * c + m[14]!) / w0,
      z1 = (m[2]! * e + m[6]! * f + m[10]! * g + m[14]!) / w1,
      depth = z0 + part * (z1 - z0);
    if (off >= best.off - 0.5 && !(off < reach && depth < best.depth)) return;
    best.off = off;
    best.depth = depth;
    best.d = d;
    best.segment = segment;
    best.part = part;
    best.length = Math.sqrt(square);
  }

  /// True if something in the box may be within reach of the pointer.
  may_hit(box: Box3): boolean {
    let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < 8; i++) {
      corner.set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
      const { m } = this,
        w = m[3]! * corner.x + m[7]! * corner.y + m[11]! * corner.z + m[15]!;
      if (!(w > 0)) return true; // next to or behind the eye: it cannot be excluded
      const px = ((m[0]! * corner.x + m[4]! * corner.y + m[8]! * corner.z + m[12]!) / w + 1) * 0.5 * this.width;
      const py = (1 - (m[1]! * corner.x + m[5]! * corner.y + m[9]! * corner.z + m[13]!) / w) * 0.5 * this.height;
      left = Math.min(left, px);
      right = Math.max(right, px);
      top = Math.min(top, py);
      bottom = Math.max(bottom, py);
    }
    return this.x > left - reach && this.x < right + reach && this.y > top - reach && this.y < bottom + reach;
  }
}
const corner = new Vector3();

export function pick(
  all: readonly Drawn[],
  eye: Eye,
  x: number,
  y: number,
  width: number,
  height: number,
  zero: Point,
): Hit | null {
  const screen = new Screen(eye, zero, x, y, width, height),
    best: Best = { off: reach, depth: Infinity, d: null, segment: 0, part: 0, length: 0 };
  for (const d of all) {
    if (!d.visible || !screen.may_hit(d.box)) continue;
    const { points, ends } = d.segments;
    for (let s = d.from; s < ends.length; s++) screen.near(points, 6 * s, 6 * s + 3, best, d, s);
  }
  return best.d && finely(screen, best.d, best.segment, zero);
}

/// A coarsely drawn line represents several motions: finds the right one. They are within half a pixel of the line.
function finely(screen: Screen, d: Drawn, segment: number, zero: Point): Hit {
  const { starts, ends } = d.segments,
    { piece: p } = d,
    best: Best = { off: Infinity, depth: Infinity, d, segment: ends[segment]!, part: 1, length: 0 };
  for (let i = starts[segment]! + 1; i <= ends[segment]!; i++)
    if (p.kinds[4 * i] !== jump) screen.near(p.at, 3 * i - 3, 3 * i, best, d, i);
  const i = best.segment,
    part = (1 - best.part) * best.length < snap ? 1 : best.part * best.length < snap ? 0 : best.part;
  const at = (k: number): Point => minus([p.at[3 * k]!, p.at[3 * k + 1]!, p.at[3 * k + 2]!], zero),
    a = at(i - 1),
    b = at(i),
    arc = arc_at(p, i);
  const on = (k: 0 | 1 | 2): number => a[k] + part * (b[k] - a[k]);
  return {
    vertex: vertex_of(p, i, zero),
    place: [on(0), on(1), on(2)],
    anchor: anchor_of(a, b, end_of_arc(p, i, part), arc && { ...arc, centre: minus(arc.centre, zero) }, p.lines[i]!),
  };
}

export function vertex_of(p: Piece, i: number, zero: Point): SceneVertex {
  const at = (k: number): Point => [p.at[3 * k]! - zero[0], p.at[3 * k + 1]! - zero[1], p.at[3 * k + 2]! - zero[2]];
  return {
    which: p.which,
    at: at(i),
    time: p.start + p.times[i]!,
    line: p.lines[i]!,
    file: p.tools[2 * i + 1]!,
    number: p.numbers[i]!,
    kind: p.kinds[4 * i]!,
    tool: p.tools[2 * i]!,
    feed: p.feeds[i]!,
    speed: p.speeds[i]!,
    radius: arc_at(p, i)?.radius,
    length: length_of(p, i),
  };
}

/// Vertices within an arc are not corners: only its own ends are points to measure from.
function end_of_arc(p: Piece, i: number, part: number): number {
  const kind = p.kinds[4 * i]!,
    joins = (k: number): boolean => k > 0 && k < p.count && p.numbers[k] === p.numbers[i] && p.kinds[4 * k] === kind;
  const inside = is_arc(kind) && ((part === 1 && joins(i + 1)) || (part === 0 && joins(i - 1)));
  return inside ? 0.5 : part;
}

/// Length of the whole motion that a vertex belongs to, as far as this piece contains it.
function length_of(p: Piece, i: number): number {
  const kind = p.kinds[4 * i]!,
    bent = is_arc(kind) || kind === spline;
  const joins = (k: number): boolean =>
    bent && k > 0 && k < p.count && p.numbers[k] === p.numbers[i] && p.kinds[4 * k] === kind;
  let first = i,
    last = i,
    sum = 0;
  while (joins(first - 1)) first--;
  while (joins(last + 1)) last++;
  for (let k = Math.max(1, first); k <= last; k++)
    sum += Math.hypot(
      p.at[3 * k]! - p.at[3 * k - 3]!,
      p.at[3 * k + 1]! - p.at[3 * k - 2]!,
      p.at[3 * k + 2]! - p.at[3 * k - 1]!,
    );
  return sum;
}
