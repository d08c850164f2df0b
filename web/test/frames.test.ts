// Tests how frames of the 3D view are read: their columns, and that invalid ones are refused.
import { describe, expect, it } from "vitest";
import { read_frame, type PartFrame, type PathFrame, type RowsFrame } from "../src/protocol/frames";
import { add_rows, piece_of } from "../src/scene/frame";
import { path_frame, piece } from "./pieces";

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
