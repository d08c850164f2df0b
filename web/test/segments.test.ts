// Tests what of a path is drawn: levels, segments and their colours, filters, how much of it.
import { describe, expect, it } from "vitest";
import { light, packed, ramp, ranges_of } from "../src/scene/colours";
import { every_of, level_for, level_within, segments_at } from "../src/scene/level";
import { run, segments_of } from "../src/scene/segments";
import { ends, look, piece } from "./pieces";

describe("levels", () => {
  it("are as coarse as half a pixel allows, not coarser", () => {
    expect(level_for(0.001)).toBe(0);
    for (const mm of [0.01, 0.3, 1, 7]) {
      const l = level_for(mm);
      expect(0.001 * 2 ** l).toBeLessThanOrEqual(mm / 2);
      if (l < 15) expect(0.001 * 2 ** (l + 1)).toBeGreaterThan(mm / 2);
    }
    expect(level_for(1e9)).toBe(15);
    expect(level_for(NaN)).toBe(0);
  });
  it("grow until the budget is kept", () => {
    const p = piece(Array.from({ length: 101 }, (_, i) => ({ x: i, level: i % 10 === 0 ? 15 : i % 2 ? 0 : 3 })));
    expect(segments_at([p], 0)).toBe(100);
    expect(level_within([p], 0, 100)).toBe(0);
    expect(level_within([p], 0, 60)).toBe(1);
    expect(level_within([p], 0, 20)).toBe(4);
    expect(level_within([p], 0, 1)).toBe(15);
  });
});

describe("segments", () => {
  const p = piece([
    { x: 0, kind: 0 },
    { x: 1, level: 0 },
    { x: 2, level: 4 },
    { x: 3, kind: 0 },
    { x: 4, kind: 1, line: 9 },
    { x: 5, z: -2, tool: 2 },
  ]);
  it("leave out what the level leaves out, and break at a jump", () => {
    expect(ends(p, 0)).toEqual([1, 2, 4, 5]);
    expect(ends(p, 1)).toEqual([2, 4, 5]);
    expect(ends(p, 5)).toEqual([4, 5]);
  });
  it("join what is kept, and know which vertices", () => {
    const s = segments_of(p, look(1));
    expect([...s.points.slice(0, 6)]).toEqual([0, 0, 0, 2, 0, 0]);
    expect([...s.starts]).toEqual([0, 3, 4]);
  });
  it("have one colour at both ends, of what they stand for", () => {
    const s = segments_of(p, look(0));
    expect(s.colours[0]).toBe(packed(light.kinds[2]!));
    expect(s.colours[1]).toBe(s.colours[0]);
    expect([s.colours[4], s.colours[5]]).toEqual([packed(light.rapid), packed(light.rapid)]);
  });
  it("are coloured along the ramp", () => {
    const q = piece([
      { x: 0, kind: 0 },
      { x: 1, feed: 100 },
      { x: 2, feed: 200 },
      { x: 3, feed: 300, kind: 1 },
    ]);
    const s = segments_of(q, { ...look(0), by: "feed", ranges: ranges_of([q]) });
    expect([s.colours[0], s.colours[2], s.colours[4]]).toEqual([
      packed(ramp(0, [0, 1])),
      packed(ramp(1, [0, 1])),
      packed(light.rapid),
    ]);
  });
  it("are filtered by depth from the zero", () => {
    const q = piece([
      { x: 0, kind: 0 },
      { x: 1, z: 10 },
      { x: 2, z: 12 },
    ]);
    expect([...segments_of(q, { ...look(0, { depth: [1, 3] }), zero_z: 10 }).ends]).toEqual([2]);
  });
  it("are filtered", () => {
    expect(ends(p, 0, { rapids: false })).toEqual([1, 2, 5]);
    expect(ends(p, 0, { tools: [2] })).toEqual([5]);
    expect(ends(p, 0, { depth: [-3, -1] })).toEqual([5]);
    expect(ends(p, 0, { lines: [9, Infinity] })).toEqual([4]);
  });
});

it("where lines lie too thick, each so manieth run is drawn, an odd one, as finely as ever", () => {
  expect([0.5, 1, 1.5, 2, 5, 1e9].map((over) => every_of(over * 1000, 1000))).toEqual([1, 1, 3, 3, 9, 129]);
  const p = piece([{ x: 0, kind: 0 }, ...Array.from({ length: 4 * run }, (_, i) => ({ x: i + 1 }))]);
  const drawn = (every: number, runs_before = 0): number[] => [
    ...new Set([...segments_of(p, { ...look(0), every, runs_before }).ends].map((i) => Math.floor((i - 1) / run))),
  ];
  expect(drawn(1)).toEqual([0, 1, 2, 3]);
  expect(drawn(3)).toEqual([0, 3]);
  expect(drawn(3, 1)).toEqual([2]);
  expect(segments_of(p, { ...look(0), every: 3 }).ends.length).toBe(2 * run);
  expect(p.length).toBe(4 * run);
});
