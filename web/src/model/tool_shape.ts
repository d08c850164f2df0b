// Computes the outline of a tool from its sizes: [diameter, height above the tip], of cutting part, shank and holder
// (docs/commands/cut.md, Tools).
import type { Insert, Tool } from "../protocol/types";

export type Outline = [number, number][];
export interface Shape {
  number: number;
  cutting: Outline;
  shank: Outline;
  holder: Outline;
  inserts?: Insert[];
}

/// Returns the shape with the outlines of its insert, if it is a turning tool.
export function with_inserts(shape: Shape, inserts: readonly Insert[]): Shape {
  const own = inserts.filter((x) => x.tool === shape.number);
  return own.length ? { ...shape, inserts: own } : shape;
}

/// Returns a tool to begin with: the first called one that has no shape yet, else one with the next number.
export function new_tool(tools: readonly Tool[], called: readonly number[]): Tool {
  const numbers = tools.map((x) => x.number),
    number = called.find((n) => !numbers.includes(n)) ?? Math.max(0, ...numbers) + 1;
  return { number, kind: "flat", diameter: 10, flute_length: 20, length: 50 };
}

const arc_steps = 8; // per quarter circle: finer than a pixel of the pictures

export function shape_of(tool: Tool): Shape {
  if (tool.kind === "turning") return { number: tool.number, cutting: [], shank: [], holder: [] }; // it has no rotational symmetry
  const d = tool.diameter ?? 0,
    flutes = tool.flute_length ?? Math.max(d * 2, 10),
    length = Math.max(tool.length ?? flutes, flutes);
  const shank = outline(tool.shank),
    holder = outline(tool.holder);
  return {
    number: tool.number,
    cutting: cutting_part(tool, d, flutes),
    shank: shank.length
      ? shank
      : length > flutes && d > 0
        ? [
            [d, flutes],
            [d, length],
          ]
        : [],
    holder: holder.map(([w, z]) => [w, z + length]),
  };
}

function cutting_part(tool: Tool, d: number, flutes: number): Outline {
  const profile = outline(tool.profile);
  if (profile.length) return profile;
  switch (tool.kind) {
    case "ball":
      return [...corner(d, d / 2), [d, flutes]];
    case "bull":
      return [...corner(d, Math.min(tool.corner ?? 0, d / 2)), [d, flutes]];
    case "drill":
      return pointed(d, tool.tip ?? 0, tool.angle ?? 118, flutes);
    case "chamfer":
      return pointed(d, tool.tip ?? 0, tool.angle ?? 90, flutes);
    case "taper":
      return [
        [0, 0],
        [Math.max(0, d - 2 * flutes * Math.tan(radians(tool.angle ?? 0))), 0],
        [d, flutes],
      ];
    default:
      return [
        [0, 0],
        [d, 0],
        [d, flutes],
      ];
  }
}

function corner(d: number, r: number): Outline {
  const out: Outline = [[0, 0]];
  for (let i = 0; i <= arc_steps; i++) {
    const a = (Math.PI / 2) * (i / arc_steps);
    out.push([d - 2 * r + 2 * r * Math.sin(a), r - r * Math.cos(a)]);
  }
  return out;
}

function pointed(d: number, tip: number, angle: number, flutes: number): Outline {
  const height = (d - tip) / 2 / Math.tan(radians(angle / 2));
  return [
    [0, 0],
    [tip, 0],
    [d, height],
    [d, Math.max(flutes, height)],
  ];
}

const radians = (degrees: number): number => (degrees * Math.PI) / 180;
const outline = (v: unknown): Outline =>
  Array.isArray(v) ? (v.filter((p) => Array.isArray(p) && p.length >= 2) as Outline) : [];
