// The interface of the 3D view. Lengths in mm, times in s, relative to the picture's zero.
import type { Bounds, Box, Insert } from "../protocol/types";

export type Point = [number, number, number];
export type ColourBy = "kind" | "tool" | "feed" | "speed" | "slowed" | "time" | "depth";
/// What a click is for.
export type SceneMode = "orbit" | "measure" | "touch";
export type ViewName = "top" | "front" | "left" | "right" | "back" | "bottom" | "iso" | "fit";
export interface SceneVertex {
  which: number;
  at: Point;
  time: number;
  line: number;
  file: number;
  number: number;
  kind: number;
  tool: number;
  feed: number;
  speed: number;
  radius?: number;
  length?: number;
}
export interface SceneFilter {
  rapids: boolean;
  tools: number[] | null;
  depth: [number, number] | null;
  lines: [number, number] | null;
  hideDone: boolean;
  programmed: boolean;
  other: boolean;
  bounds: boolean;
  turned: boolean; // turned: the part as it is on the machine
}
export const usual_filter: SceneFilter = {
  rapids: true,
  tools: null,
  depth: null,
  lines: null,
  hideDone: false,
  programmed: false,
  other: true,
  bounds: true,
  turned: true,
};
export interface SceneBox {
  name: string;
  kind: "stock" | "extents" | "limits" | "zone";
  box: Box;
  over?: boolean;
}
export type SceneBounds = Bounds;
/// Outlines of [diameter, height over the tip], from below upwards.
export interface ToolShape {
  number: number;
  cutting: [number, number][];
  shank: [number, number][];
  holder: [number, number][];
  inserts?: Insert[]; // of a turning tool
}
/// The point or edge that a click in the view measures from. `direction`: of an edge, length 1.
export interface Anchor {
  kind: "point" | "edge" | "centre";
  place: Point;
  direction?: Point;
  radius?: number;
  line: number;
}
/// `angle`: degrees between two edges that are not parallel.
export interface Distance {
  from: Point;
  to: Point;
  distance: number;
  delta: Point;
  angle: number | null;
}
export interface Measured {
  ends: Anchor[];
  distance: Distance | null;
}
/// The orientation of the eye: axes of the screen, and the screen position of a point from the picture's zero (null
/// behind the eye).
export interface View {
  right: Point;
  up: Point;
  towards: Point;
  turned(p: Point): Point; // from the axes of a mill's views to the machine's: other axes are up on a lathe
  place(p: Point): [number, number] | null;
}
export interface SceneEvents {
  pick(v: SceneVertex | null): void;
  hover(v: SceneVertex | null, x: number, y: number): void;
  measured(m: Measured): void;
  touched(place: Point, normal: Point): void; // the part's surface, where the mode requests it
  thinned(drawn: number, all: number): void;
  turned(view: View): void; // after each picture
}

/// Thrown if the browser has no WebGL: the page continues without this view.
export class NoWebGl extends Error {}
