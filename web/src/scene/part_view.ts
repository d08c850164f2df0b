// The part as it is cut: each surface has the colour of the tool that made it, the blank's own surface is grey.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, MeshLambertMaterial, type Plane } from "three";
import type { PartFrame } from "../protocol/frames";
import { by_tool, type Theme } from "./colours";
import type { Point } from "./types";

const blank = 65535; // "made by" of a surface that no tool has touched
const pale = 0.55; // how far a tool's colour is mixed with that of the blank, so that the path in full colour remains visible on it

/// Both sides are drawn, so that a section is not open.
/// `quarter`: only what is outside all planes is cut off, not what is outside one of them.
export function part_mesh(part: PartFrame, zero: Point, theme: Theme, planes: Plane[], quarter = false): Mesh {
  const g = new BufferGeometry(),
    n = part.points.length / 3,
    points = new Float32Array(3 * n),
    colours = new Uint8Array(3 * n);
  const of = new Map<number, [number, number, number]>();
  for (let i = 0; i < n; i++) {
    for (let k = 0; k < 3; k++) points[3 * i + k] = part.points[3 * i + k]! - zero[k]!;
    const tool = part.made_by[2 * i]!;
    let colour = of.get(tool);
    if (!colour) of.set(tool, (colour = part_colour(tool, theme)));
    colours[3 * i] = colour[0];
    colours[3 * i + 1] = colour[1];
    colours[3 * i + 2] = colour[2];
  }
  g.setAttribute("position", new BufferAttribute(points, 3));
  g.setAttribute("color", new BufferAttribute(colours, 3, true));
  g.setIndex(new BufferAttribute(part.triangles, 1));
  const material = part_material(planes);
  material.clipIntersection = quarter;
  return new Mesh(g, material);
}

/// Flat shading: a face of the part keeps its edges, and the frame needs no normals.
export const part_material = (planes: Plane[]): MeshLambertMaterial =>
  new MeshLambertMaterial({
    vertexColors: true,
    flatShading: true,
    side: DoubleSide,
    clippingPlanes: planes,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });

/// Linear, as vertex colours must be.
export function part_colour(tool: number, theme: Theme): [number, number, number] {
  const colour = new Color(theme.part);
  if (tool !== blank) {
    const [r, g, b] = by_tool[tool % by_tool.length]!;
    colour.lerp(new Color(`rgb(${r}, ${g}, ${b})`), 1 - pale);
  }
  return [Math.round(colour.r * 255), Math.round(colour.g * 255), Math.round(colour.b * 255)];
}
