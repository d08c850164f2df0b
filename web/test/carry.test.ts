// Tests the part as it is on the machine: joints in their order, and the eye that rotates about it.
import { describe, expect, it } from "vitest";
import { Matrix4, Vector3 } from "three";
import type { Joint } from "../src/protocol/types";
import { Eye } from "../src/scene/camera";
import { carry_of } from "../src/scene/carry";
import { read_frame, type PathFrame, type RowsFrame } from "../src/protocol/frames";
import { add_rows, piece_of } from "../src/scene/frame";
import { place_at } from "../src/scene/place";
import type { Point } from "../src/scene/types";

const a: Joint = { axis: "A", turns: true, direction: [1, 0, 0], through: [0, 0, 10], from: 0 };
const c: Joint = { axis: "C", turns: true, direction: [0, 0, -1], through: [5, 0, 0], from: 0 };
const put = (m: Matrix4, p: Point): number[] =>
  new Vector3(...p)
    .applyMatrix4(m)
    .toArray()
    .map((v) => +v.toFixed(9) + 0);

describe("the part on the machine", () => {
  it("turns about a line through a point, right-handed", () => {
    expect(put(carry_of([a], [90], [0, 0, 0]), [7, 2, 10])).toEqual([7, 0, 12]);
    expect(put(carry_of([c], [90], [0, 0, 0]), [6, 0, 3])).toEqual([5, -1, 3]);
  });
  it("is carried by the first joint last", () => {
    expect(put(carry_of([a, c], [90, 90], [0, 0, 0]), [6, 0, 10])).toEqual([5, 0, 9]);
  });
  it("goes along a joint that does not turn", () => {
    expect(
      put(
        carry_of(
          [a, { axis: "Y", turns: false, direction: [0, -1, 0], through: [0, 0, 0], from: 0 }],
          [90, 3],
          [0, 0, 0],
        ),
        [0, 5, 10],
      ),
    ).toEqual([0, 0, 12]);
  });
  it("lies as drawn where its joints are at `from`", () => {
    const from = [
      { ...a, from: 30 },
      { ...c, from: -200 },
    ];
    expect(put(carry_of(from, [30, -200], [1, 2, 3]), [7, 8, 9])).toEqual([7, 8, 9]);
  });
  it("reckons from the picture's zero", () => {
    expect(put(carry_of([a], [90], [7, 2, 10]), [0, 0, 0])).toEqual([0, -2, 2]);
  });
});

describe("the eye", () => {
  it("sees the part turned, by going round it", () => {
    const eye = new Eye(),
      carry = carry_of([a], [35], [0, 0, 0]),
      p = new Vector3(3, 4, 5);
    const seen = (): number[] =>
      p
        .clone()
        .project(eye.camera)
        .toArray()
        .map((v) => +v.toFixed(6));
    eye.size(800, 600);
    eye.update();
    p.applyMatrix4(carry);
    const wanted = seen();
    p.set(3, 4, 5);
    expect(seen()).not.toEqual(wanted);
    eye.set_carry(carry);
    eye.update();
    expect(seen()).toEqual(wanted);
    eye.fit([2, 3, 4], [4, 5, 6]);
    eye.update();
    expect(Math.hypot(seen()[0]!, seen()[1]!)).toBeLessThan(1e-5); // in the middle
  });
});

describe("positions of the joints", () => {
  const path = new ArrayBuffer(96 + 2 * 40),
    v = new DataView(path);
  [1, 0, 2, 0].forEach((x, i) => v.setUint32(4 * i, x, true));
  v.setFloat32(96 + 24 + 4, 2, true); // the second vertex, two seconds later
  v.setUint8(96 + 24 + 8 * 6 + 4, 2);
  const frame = (values: number[], count = 2): ArrayBuffer => {
    const f = new ArrayBuffer(16 + 4 * values.length),
      w = new DataView(f);
    [4, 0, count, 0].forEach((x, i) => w.setUint32(4 * i, x, true));
    values.forEach((x, i) => w.setFloat32(16 + 4 * i, x, true));
    return f;
  };
  it("lie between those of two vertices", () => {
    const piece = piece_of(read_frame(path) as PathFrame);
    expect(add_rows(piece, read_frame(frame([10, 0, 30, 90])) as RowsFrame)).toBe(true);
    expect(place_at([piece], 1)?.positions).toEqual([20, 45]);
    expect(place_at([piece], 9)?.positions).toEqual([30, 90]);
  });
  it("are refused where they are not as many for each vertex, no numbers, or of another piece", () => {
    for (const bad of [frame([1, 2, 3]), frame([]), frame([1, NaN])]) expect(read_frame(bad)).toBeNull();
    const piece = piece_of(read_frame(path) as PathFrame);
    expect([add_rows(piece, read_frame(frame([1, 2, 3], 3)) as RowsFrame), piece.positions]).toEqual([
      false,
      undefined,
    ]);
  });
});
