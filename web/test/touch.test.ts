import { describe, expect, it } from "vitest";
import { touch_at } from "../src/model/touch";

const rules = { clearance: 20, away: 5, feed: 100, radius: 2 };
/// The work offset is (100, 50, -200); the tool is 30 long.
const panel = {
  position: { X: 1, Y: 2, Z: 10 },
  machine: { X: 101, Y: 52, Z: -160 },
  zero: { X: 100, Y: 50, Z: -200 },
};
const zero: [number, number, number] = [100, 50, -200];

describe("touch_at", () => {
  it("comes down onto what looks up, over the clearance", () => {
    const touch = touch_at([7, 8, -4], [0.01, 0, 1], zero, panel, rules)!;
    expect([touch.axis, touch.sense, touch.at]).toEqual(["Z", 1, -4]);
    expect(touch.way).toEqual([
      { rapid: true, to: { Z: -150 }, feed: 0 },
      { rapid: true, to: { X: 107, Y: 58 }, feed: 0 },
      { rapid: true, to: { Z: -169 }, feed: 0 },
      { rapid: false, to: { Z: -174 }, feed: 100 },
      { rapid: true, to: { Z: -169 }, feed: 0 },
      { rapid: true, to: { Z: -150 }, feed: 0 },
    ]);
  });
  it("comes from the side that a wall looks to, with the ball's middle beside the place", () => {
    const touch = touch_at([7, 8, -4], [-1, 0, 0], zero, panel, rules)!;
    expect([touch.axis, touch.sense, touch.at]).toEqual(["X", -1, 7]);
    expect(touch.way).toEqual([
      { rapid: true, to: { Z: -150 }, feed: 0 },
      { rapid: true, to: { X: 100, Y: 58 }, feed: 0 },
      { rapid: false, to: { Z: -176 }, feed: 100 },
      { rapid: false, to: { X: 105 }, feed: 100 },
      { rapid: true, to: { X: 100 }, feed: 0 },
      { rapid: true, to: { Z: -150 }, feed: 0 },
    ]);
  });
  it("does not go up where it stands above the clearance", () => {
    const touch = touch_at(
      [7, 8, -4],
      [0, 0, 1],
      zero,
      { ...panel, position: { X: 1, Y: 2, Z: 60 }, machine: { X: 101, Y: 52, Z: -110 } },
      rules,
    )!;
    expect(touch.way[0]!.to).toEqual({ X: 107, Y: 58 });
  });
  it("counts from the zero in force, not from the picture's", () => {
    const touch = touch_at(
      [7, 8, -4],
      [0, 0, 1],
      zero,
      { ...panel, zero: { X: 90, Y: 50, Z: -203 }, position: { X: 11, Y: 2, Z: 13 } },
      rules,
    )!;
    expect(touch.at).toBe(-1);
    expect(touch.way.find((w) => "X" in w.to)!.to).toEqual({ X: 107, Y: 58 });
  });
  it("refuses what looks down, and what lies aslant to all axes", () => {
    expect(touch_at([0, 0, 0], [0, 0, -1], zero, panel, rules)).toBeNull();
    expect(touch_at([0, 0, 0], [0.58, 0.58, 0.57], zero, panel, rules)).toBeNull();
  });
});
