// Objects in the view besides the path: the tool, the part, boxes, the highlighted line.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LatheGeometry,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  Vector2,
  Vector3,
  type Material,
  type Object3D,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { jump } from "../protocol/frames";
import type { Theme } from "./colours";
import type { Point, ToolShape } from "./types";
import type { Drawn } from "./built_lines";
import { insert_mesh } from "./turned_view";

const around = 64,
  up = new Vector3(0, 0, 1);
const most_lit = 50_000; // highlighted segments of one line: more cannot be distinguished

export function empty(group: Object3D): void {
  for (const o of [...group.children] as Mesh[]) {
    group.remove(o);
    o.geometry?.dispose();
    (o.material as Material | undefined)?.dispose?.();
    empty(o);
  }
}

/// Returns the tool in its true shape, with the tip at the origin; without a shape a cone of that height.
export function tool_mesh(shape: ToolShape | undefined, cone: number, theme: Theme): Group {
  if (shape?.inserts?.length) return insert_mesh(shape.inserts, theme);
  const group = new Group();
  const lathe = (outline: readonly [number, number][], colour: number, opacity: number): void => {
    const points = outline.map(([d, z]) => new Vector2(d / 2, z));
    if (points.length < 2) return;
    if (points[points.length - 1]!.x > 0) points.push(new Vector2(0, points[points.length - 1]!.y));
    if (points[0]!.x > 0) points.unshift(new Vector2(0, points[0]!.y));
    group.add(
      new Mesh(
        new LatheGeometry(points, around).rotateX(Math.PI / 2),
        new MeshLambertMaterial({ color: colour, transparent: true, opacity, flatShading: true, side: DoubleSide }),
      ),
    );
  };
  if (!shape || shape.cutting.every(([d]) => d <= 0))
    lathe(
      [
        [0, 0],
        [cone * 0.5, cone],
      ],
      theme.tool,
      0.85,
    );
  else {
    lathe(shape.cutting, theme.tool, 0.85);
    lathe(shape.shank, theme.holder, 0.6);
    lathe(shape.holder, theme.holder, 0.45);
  }
  return group;
}

/// Makes a tool translucent, so that what is behind it can be seen.
export function fade(tool: Object3D): void {
  const share = 0.25;
  tool.traverse((o) => {
    const material = (o as Mesh).material as Material | undefined;
    if (!material) return;
    material.transparent = true;
    material.opacity *= share;
    material.depthWrite = false;
  });
}

export function put_tool(tool: Group, at: Point, lean: Point | null): void {
  tool.position.set(...at);
  tool.quaternion.setFromUnitVectors(up, lean ? new Vector3(...lean).normalize() : up);
}

/// Returns the ends of every segment of a program line, in full detail.
export function lit_points(all: readonly Drawn[], line: number, file: number, zero: Point): Float32Array {
  const out: number[] = [];
  for (const { piece: p } of all) {
    if (p.which !== 0 || line < p.line_range[0] || line > p.line_range[1]) continue;
    for (let i = 1; i < p.count && out.length < 6 * most_lit; i++) {
      if (p.lines[i] !== line || p.tools[2 * i + 1] !== file || p.kinds[4 * i] === jump) continue;
      for (const j of [i - 1, i]) for (let k = 0; k < 3; k++) out.push(p.at[3 * j + k]! - zero[k]!);
    }
  }
  return new Float32Array(out);
}

/// The three axes at the picture's zero: X red, Y green, Z blue, as usual.
export function axes(length: number): LineSegments {
  const g = new BufferGeometry(),
    c = [0.85, 0.2, 0.2, 0.85, 0.2, 0.2, 0.15, 0.6, 0.25, 0.15, 0.6, 0.25, 0.2, 0.4, 0.95, 0.2, 0.4, 0.95];
  g.setAttribute(
    "position",
    new BufferAttribute(new Float32Array([0, 0, 0, length, 0, 0, 0, 0, 0, 0, length, 0, 0, 0, 0, 0, 0, length]), 3),
  );
  g.setAttribute("color", new BufferAttribute(new Float32Array(c), 3));
  return new LineSegments(g, new LineBasicMaterial({ vertexColors: true }));
}

/// A line over everything else.
export function thick(points: number[], width: number, colour: number): LineSegments2 {
  const line = new LineSegments2(
    new LineSegmentsGeometry().setPositions(points),
    new LineMaterial({ linewidth: width, depthTest: false, color: colour }),
  );
  line.renderOrder = 3;
  return line;
}
