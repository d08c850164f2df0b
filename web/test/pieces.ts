// Pieces of a path for tests of the 3D view, made of their frames.
import { read_frame, type PathFrame } from "../src/protocol/frames";
import { light, ranges_of } from "../src/scene/colours";
import { piece_of, type Piece } from "../src/scene/frame";
import { segments_of, type Look } from "../src/scene/segments";
import { usual_filter, type SceneFilter } from "../src/scene/types";

export interface Vertex {
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

export function path_frame(vertices: Vertex[], start = 0, which = 0): ArrayBuffer {
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
export const piece = (vertices: Vertex[], start = 0): Piece =>
  piece_of(read_frame(path_frame(vertices, start)) as PathFrame);
export const look = (level: number, filter: Partial<SceneFilter> = {}): Look => ({
  level,
  filter: { ...usual_filter, programmed: true, ...filter },
  by: "kind",
  ranges: ranges_of([]),
  theme: light,
  zero_z: 0,
});
export const ends = (p: Piece, level: number, filter?: Partial<SceneFilter>): number[] => [
  ...segments_of(p, look(level, filter)).ends,
];
