// Tests the arithmetic of the 3D view: invalid frames, levels, what is drawn at them, the position of the tool.
import { describe, expect, it } from "vitest";
import { read_frame, type PartFrame, type PathFrame, type RowsFrame } from "../src/protocol/frames";
import { Eye } from "../src/scene/camera";
import { dark, light, packed, ramp, ranges_of, slowed } from "../src/scene/colours";
import { add_rows, piece_of, type Piece } from "../src/scene/frame";
import { every_of, level_for, level_within, segments_at } from "../src/scene/level";
import { draws_softly, Pace } from "../src/scene/pace";
import { place_at } from "../src/scene/place";
import { run, segments_of, type Look } from "../src/scene/segments";
import type { SceneFilter } from "../src/scene/types";

interface V {
  x: number;
  y?: number;
  z?: number;
  t?: number;
  line?: number;
  tool?: number;
  kind?: number;
  level?: number;
  feed?: number;
}

function path_frame(vertices: V[], start = 0, which = 0): ArrayBuffer {
  const n = vertices.length,
    frame = new ArrayBuffer(96 + 40 * n),
    v = new DataView(frame);
  [1, which, n, 0].forEach((x, i) => v.setUint32(4 * i, x, true));
  v.setFloat64(16, start, true);
  for (let l = 0; l < 16; l++) v.setUint16(56 + 2 * l, vertices.filter((p) => (p.level ?? 15) >= l).length, true);
  vertices.forEach((p, i) => {
    [p.x, p.y ?? 0, p.z ?? 0].forEach((c, k) => v.setFloat32(96 + 12 * i + 4 * k, c, true));
    const at = (column: number): number => 96 + 12 * n + 4 * n * column + 4 * i;
    v.setFloat32(at(0), p.t ?? i, true);
    v.setUint32(at(1), p.line ?? i, true);
    v.setFloat32(at(3), p.feed ?? 100, true);
    v.setUint16(at(5), p.tool ?? 1, true);
    v.setUint8(at(6), p.kind ?? 2);
    v.setUint8(at(6) + 1, p.level ?? 15);
  });
  return frame;
}
const piece = (vertices: V[], start = 0): Piece => piece_of(read_frame(path_frame(vertices, start)) as PathFrame);
const all: SceneFilter = {
  rapids: true,
  tools: null,
  depth: null,
  lines: null,
  hideDone: false,
  programmed: true,
  other: true,
  bounds: true,
  turned: true,
};
const look = (level: number, filter: Partial<SceneFilter> = {}): Look => ({
  level,
  filter: { ...all, ...filter },
  by: "kind",
  ranges: ranges_of([]),
  theme: light,
  zero_z: 0,
});
const ends = (p: Piece, level: number, filter?: Partial<SceneFilter>): number[] => [
  ...segments_of(p, look(level, filter)).ends,
];

describe("frames", () => {
  const good = path_frame([
    { x: 0, kind: 0 },
    { x: 1, tool: 7 },
    { x: 2, kind: 1 },
  ]);
  it("gives the columns", () => {
    const p = piece_of(read_frame(good) as PathFrame);
    expect([p.count, p.at[3], p.tools[2], p.kinds[8]]).toEqual([3, 1, 7, 1]);
    expect(p.cut).toEqual([
      [0, 0, 0],
      [1, 0, 0],
    ]);
  });
  it("refuses what is shorter than it says, at every length", () => {
    for (let n = 0; n < good.byteLength; n++) expect(read_frame(good.slice(0, n))).toBeNull();
  });
  it("refuses counts out of bounds, and places that are no numbers", () => {
    for (const count of [0, 8193, 0xffffffff]) {
      const f = good.slice(0);
      new DataView(f).setUint32(8, count, true);
      expect(read_frame(f)).toBeNull();
    }
    expect(read_frame(path_frame([{ x: NaN }]))).toBeNull();
    expect(read_frame(path_frame([{ x: 0 }], Infinity))).toBeNull();
  });
  it("takes directions only for as many vertices as the piece has", () => {
    const f = new ArrayBuffer(16 + 36),
      v = new DataView(f);
    [2, 0, 3, 0].forEach((x, i) => v.setUint32(4 * i, x, true));
    v.setFloat32(16 + 8, 1, true);
    const rows = read_frame(f) as RowsFrame,
      p = piece_of(read_frame(good) as PathFrame),
      other = piece([{ x: 0 }]);
    expect([add_rows(p, rows), p.leans?.[2], p.positions]).toEqual([true, 1, undefined]);
    expect([add_rows(other, rows), other.leans]).toEqual([false, undefined]);
    expect(read_frame(f.slice(0, 40))).toBeNull();
  });
  it("refuses a part whose triangle names no point", () => {
    const f = new ArrayBuffer(16 + 3 * 20 + 12),
      v = new DataView(f);
    [3, 0, 3, 1].forEach((x, i) => v.setUint32(4 * i, x, true));
    [0, 1, 2].forEach((x, i) => v.setUint32(16 + 36 + 4 * i, x, true));
    expect((read_frame(f) as PartFrame).triangles.length).toBe(3);
    expect(read_frame(f.slice(0, f.byteLength - 1))).toBeNull();
    v.setUint32(16 + 36, 3, true);
    expect(read_frame(f)).toBeNull();
  });
});

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

describe("places", () => {
  const pieces = [
    piece([
      { x: 0, t: 0, kind: 0 },
      { x: 10, t: 2 },
      { x: 10, t: 5 },
    ]),
    piece(
      [
        { x: 10, t: 0 },
        { x: 20, t: 1, tool: 3 },
        { x: 90, t: 2, kind: 0 },
      ],
      5,
    ),
  ];
  const x = (t: number): number => place_at(pieces, t)!.at[0];
  it("lie between the ends of the motion", () => {
    expect([x(1), x(2), x(4), x(5.5)]).toEqual([5, 10, 10, 15]);
  });
  it("stay at the ends outside, and during a jump", () => {
    expect([x(-1), x(6.5), x(7), x(99)]).toEqual([0, 20, 90, 90]);
  });
  it("tell the tool", () => {
    expect([place_at(pieces, 1)!.tool, place_at(pieces, 5.5)!.tool]).toEqual([1, 3]);
  });
  it("are none without a path", () => {
    expect(place_at([], 1)).toBeNull();
  });
});

describe("pace", () => {
  const bounds = { least: 1000, first: 10_000, most: 50_000, wanted: 40 };
  it("goes down at once to what the time allows, not below its least", () => {
    const p = new Pace(bounds);
    p.took(80, 10_000);
    expect(p.budget).toBe(5000);
    for (let i = 0; i < 20; i++) p.took(500, p.budget);
    expect(p.budget).toBe(1000);
  });
  it("goes up by little, only while it was the budget that bound it", () => {
    const p = new Pace(bounds);
    p.took(5, 100);
    expect(p.budget).toBe(10_000);
    p.took(5, 9000);
    expect(p.budget).toBeCloseTo(11_000);
    for (let i = 0; i < 100; i++) p.took(5, p.budget);
    expect(p.budget).toBe(50_000);
  });
  it("does not blame the path for a picture with nothing in it", () => {
    const p = new Pace(bounds);
    p.took(900, 10);
    expect(p.budget).toBe(10_000);
  });
  it("knows renderers without a card", () => {
    expect(draws_softly("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)")).toBe(true);
    expect(draws_softly("llvmpipe (LLVM 15.0.6, 256 bits)")).toBe(true);
    expect(draws_softly("ANGLE (NVIDIA GeForce RTX 3060)")).toBe(false);
  });
});

describe("colours, circles, the eye", () => {
  it("the ramp keeps to its ends", () => {
    expect(ramp(-5, [0, 10])).toEqual(ramp(0, [0, 10]));
    expect(ramp(99, [0, 10])).toEqual(ramp(10, [0, 10]));
    expect(ramp(1, [Infinity, -Infinity])[3]).toBe(255);
    expect(dark.kinds.length).toBe(9);
  });
  it("zooming keeps what is under the pointer, turning what it turns about", () => {
    const eye = new Eye();
    eye.size(800, 600);
    eye.look("top");
    const under = (): number[] => {
      const m = eye.mm_per_pixel;
      return eye.target
        .clone()
        .addScaledVector(eye.right, (100 - 400) * m)
        .addScaledVector(eye.up, (300 - 50) * m)
        .toArray();
    };
    const before = under();
    eye.zoom(0.5, 100, 50);
    under().forEach((v, i) => expect(v).toBeCloseTo(before[i]!, 6));
    expect(eye.right.x).toBeCloseTo(1, 9);
    expect(eye.up.y).toBeCloseTo(1, 9);
    const pivot = eye.target.clone().addScaledVector(eye.right, 30).addScaledVector(eye.up, 20);
    eye.turn(50, -40, pivot);
    expect(pivot.clone().sub(eye.target).dot(eye.right)).toBeCloseTo(30, 6);
    expect(pivot.clone().sub(eye.target).dot(eye.up)).toBeCloseTo(20, 6);
  });
  it("on a lathe Z runs to the right and X up, and a side stays a side", () => {
    const eye = new Eye();
    eye.set_lathe(true);
    eye.look("front");
    expect(eye.right.z).toBeCloseTo(1, 9);
    expect(eye.up.x).toBeCloseTo(1, 9);
    expect(eye.towards.y).toBeCloseTo(1, 9);
    eye.look_from([1, 0, 0]);
    expect(eye.towards.x).toBeCloseTo(1, 9);
    eye.look_from([0.5, 0.5, Math.SQRT1_2]);
    expect(eye.towards.z).toBeCloseTo(Math.SQRT1_2, 9);
    eye.set_lathe(false);
    eye.look("front");
    expect(eye.up.z).toBeCloseTo(1, 9);
  });
});

it("what limits take of the feed is told in per cent", () => {
  expect(slowed(1000, 250)).toBe(75);
  expect(slowed(1000, 1000)).toBe(0);
  expect(slowed(0, 8000)).toBe(0); // rapid
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
