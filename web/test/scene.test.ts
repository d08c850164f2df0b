// Tests the arithmetic of the 3D view: the position of the tool, the pace of drawing, colours, the eye.
import { describe, expect, it } from "vitest";
import { Eye } from "../src/scene/camera";
import { dark, ramp, slowed } from "../src/scene/colours";
import { draws_softly, Pace } from "../src/scene/pace";
import { place_at } from "../src/scene/place";
import { piece } from "./pieces";

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
