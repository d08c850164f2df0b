// Messages of docs/panel-protocol.md: the cut part, the set-up sheet, two versions.
import type { Axes, Box } from "./base";
import type { Mark, Problem } from "./program";

export interface Tool {
  number: number;
  kind: string;
  diameter?: number;
  corner?: number;
  angle?: number;
  tip?: number;
  flute_length?: number;
  length?: number;
  points?: string; // of an insert: direction of its programmed point
  lead?: number;
  width?: number;
  profile?: [number, number][];
  shank?: unknown;
  holder?: unknown;
  name?: string;
  flute_count?: number;
  from?: string;
  known?: boolean;
  by_offset?: boolean; // an insert of the offset table, which the cut takes from there
}
/// The outline of one body of a turning tool, [x, z] from the programmed point.
export interface Insert {
  tool: number;
  part: "cutting" | "shank" | "holder";
  outline: [number, number][];
}
export interface CutQuestion {
  stock: string;
  tools: string | Tool[];
  fixtures?: string[];
  resolution?: number;
}
/// A problem that the cut has found.
export interface Finding extends Problem {
  file: number;
  at: number;
  place: number[];
  depth: number;
  tool: number;
}
/// A thread as it was cut; lengths in mm.
export interface CutThread {
  line: number;
  tool: number;
  lead?: number;
  passes: number;
  outer: boolean;
  from: { diameter: number; Z: number };
  to: { diameter: number; Z: number };
  crest?: number;
  depth?: number;
}
export interface CutResult {
  stock: number;
  left: number;
  removed: number;
  error_bound?: number;
  resolution?: number;
  seconds?: number;
  alarms?: number;
  warnings?: number;
  tools?: { tool: number; removed: number; seconds: number; greatest_rate: number }[];
  marks?: Mark[];
  notes?: string[];
  inserts?: Insert[];
  turned?: { surface: number; machined: number };
  threads?: CutThread[];
  error?: { text: string };
}
/// What states the blank: a comment, or line 0 and the file of the set-up.
export interface BlankSource {
  line: number;
  text: string;
}
/// A file next to the program, with the digest of the version on the disk; null: there is none yet.
export interface KeptFile {
  file: string;
  digest: string | null;
}
export interface Proposals {
  stock: string;
  stock_by?: BlankSource;
  fixtures?: string[];
  keep?: KeptFile; // the tools file of the program
  tools: Tool[];
  files?: string[];
  inserts?: Insert[];
}
/// Polygons of [radius, Z].
export type SectionPolygons = readonly (readonly (readonly [number, number])[])[];
export interface PartAnswer {
  stock: number;
  left: number;
  triangles: number;
  seconds: number;
  cell: number;
  section?: SectionPolygons;
  section_y?: SectionPolygons;
  edges?: readonly (readonly [number, number])[]; // radius and Z
}
export interface SheetTool {
  number: number;
  name?: string;
  radius?: number;
  length?: number;
  corrector?: string | number;
  seconds?: number;
  lines?: number[];
  outline?: [number, number][];
  comment?: string;
  shared?: { word: string; tools: number[] }[]; // of its offsets: other tools that use them too
}
export interface Sheet {
  program: string;
  control: string;
  machine: string | null;
  date: string;
  zeros: { name: string; values: Axes }[];
  diameters?: string[];
  tools: SheetTool[];
  extents: { cutting: Box | null; all: Box | null };
  seconds: number;
  comments: { line: number; text: string }[];
  stops: { line: number; text: string; at: number }[];
}
export interface Spot {
  line: number;
  file: number;
  number: number;
  at: number;
  to_line: number;
  to_number: number;
  to_at: number;
}
export interface Difference {
  kind: "way" | "move" | "feed" | "tool" | "spindle" | "coolant" | "act" | "end";
  text: string;
  distance: number;
  a: Spot;
  b: Spot;
}
export interface Compared {
  same: boolean;
  text: string;
  tolerance: number;
  deviation: number;
  moves: [number, number];
  first: Difference | null;
  differences: Difference[];
  more: number;
  lost: boolean;
}
