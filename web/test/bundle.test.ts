// Tests pieces that are drawn together: their segments in order, joined again only where something changed.
import { LineBasicMaterial } from "three";
import { expect, test } from "vitest";
import { Bundle, type Part } from "../src/scene/bundle";
import type { Segments } from "../src/scene/segments";

/// Segments along X from `first` on, each 1 long; the colour of a segment is its number.
function segments(first: number, count: number): Segments {
  const each = Array.from({ length: count }, (_, i) => first + i);
  return {
    points: Float32Array.from(each.flatMap((x) => [x, 0, 0, x + 1, 0, 0])),
    colours: Uint32Array.from(each.flatMap((x) => [x, x])),
    starts: Uint32Array.from(each),
    ends: Uint32Array.from(each.map((x) => x + 1)),
  };
}
const bundle_of = (...parts: Part[]): Bundle<Part> => {
  const b = new Bundle<Part>(new LineBasicMaterial(), false);
  b.parts.push(...parts);
  b.refresh();
  return b;
};
const part = (s: Segments, from = 0, visible = true): Part => ({ segments: s, from, visible });
/// The first X of each segment that is drawn.
function drawn(b: Bundle<Part>): number[] {
  if (!b.lines.visible) return [];
  const { geometry: g } = b.lines,
    at = g.getAttribute("position");
  return Array.from({ length: at.count / 2 - g.drawRange.start / 2 }, (_, i) => at.getX(g.drawRange.start + 2 * i));
}

test("parts are drawn one after another, the unseen ones not", () => {
  const b = bundle_of(part(segments(0, 2)), part(segments(2, 1)), part(segments(3, 2)));
  expect(drawn(b)).toEqual([0, 1, 2, 3, 4]);
  expect(new Uint32Array((b.lines.geometry.getAttribute("color").array as Uint8Array).buffer)[8]).toBe(4);
  b.parts[1]!.visible = false;
  b.refresh();
  expect(drawn(b)).toEqual([0, 1, 3, 4]);
  for (const p of b.parts) p.visible = false;
  b.refresh();
  expect(b.lines.visible).toBe(false);
});

test("what is over is left out at the beginning, across parts", () => {
  const b = bundle_of(part(segments(0, 2), 2), part(segments(2, 3), 1), part(segments(5, 1)));
  expect(drawn(b)).toEqual([3, 4, 5]);
  b.parts[0]!.from = b.parts[1]!.from = 0;
  b.refresh();
  expect(drawn(b)).toEqual([0, 1, 2, 3, 4, 5]);
});

test("nothing is joined anew where nothing changed; other segments of a part are seen", () => {
  const b = bundle_of(part(segments(0, 2)), part(segments(2, 2))),
    before = b.lines.geometry;
  b.refresh();
  expect(b.lines.geometry).toBe(before);
  b.parts[0]!.segments = segments(10, 1);
  b.refresh();
  expect(drawn(b)).toEqual([10, 2, 3]);
  b.drop();
  b.refresh();
  expect(drawn(b)).toEqual([10, 2, 3]);
});
