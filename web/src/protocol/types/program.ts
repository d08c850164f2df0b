// Messages of docs/panel-protocol.md: the folder, an opened program, its state and its problems.
import type { Axes, Box, JsonTable } from "./base";

export interface Hello {
  version: string;
  folder: string;
  may_change: boolean;
  last: string | null;
  controls: { id: string; name: string }[];
  machines: string[];
}
export interface FileEntry {
  name: string;
  kind: "folder" | "program" | "setup" | "tools" | "other";
  size: number;
  modified: number | string;
}
export interface Files {
  entries: FileEntry[];
  more?: boolean;
}

/// With `port` the machine is real; `accept`: rows of the proof that the operator accepts.
export interface RealQuestion extends OpenQuestion {
  port?: string;
  accept?: string[];
}
export interface OpenQuestion {
  file: string;
  control?: string;
  machine?: string;
  setup?: string;
  encoding?: string;
  text?: string;
  tables?: JsonTable;
}
/// Machine coordinates; null: no limit there.
export type Open = (number | null)[];
export interface Bounds {
  limits: [Open, Open];
  zones: { number: number; inside: boolean; box: [Open, Open] }[];
}
export interface Opened {
  file: string;
  size: number;
  digest: string;
  encoding: string;
  control: { id: string; name: string; guessed: boolean; lathe?: boolean; decisive?: boolean | string; why?: string };
  machine: string | null;
  setup: string | null;
  editable: boolean;
  lines: number;
  text?: string;
  bounds?: Bounds;
}

export type Severity = "alarm" | "warning" | "advice" | "note";
export interface Fix {
  text: string;
  line: number;
  from: number;
  to: number;
  insert: string;
}
export interface Problem {
  id: string;
  severity: Severity;
  number?: number | string;
  text: string;
  hint?: string;
  file?: string | number;
  file_name?: string;
  line: number;
  column?: number;
  end_column?: number;
  block?: string;
  calls?: string[];
  fix?: Fix;
  at?: number;
}
export interface Checked {
  problems: Problem[];
}
export interface Word {
  from: number;
  to: number;
  code: string;
  title: string;
  text: string;
}
export interface Explained {
  words: Word[];
}

export interface Call {
  what: string;
  line: number;
  block?: string;
  file?: number | string;
}
export interface Modal {
  group: string;
  code: string;
  changed?: boolean;
}
export interface Variable {
  name: string;
  value: number | string | null;
  changed?: boolean;
}
/// Constant surface speed: m/min, and the highest speed of the spindle that the program permits, rev/min.
export interface Surface {
  speed: number;
  most: number | null;
}
/// The row of a lathe's offset table that is in force: true lengths in mm, tip by its number.
export interface ToolOffset {
  row: number;
  geometry: Axes;
  wear: Axes;
  radius: number;
  tip: number;
}
export interface State {
  at: number;
  number: number;
  line: number;
  column?: number;
  file?: number;
  file_name?: string;
  block?: string;
  text?: string;
  pass?: number;
  depth?: number;
  calls?: Call[];
  position: Axes;
  machine: Axes;
  togo: Axes;
  feed: number;
  speed: number;
  rpm: number | null;
  tool: number;
  modal: Modal[];
  offsets: { T?: number; D?: number; H?: number; radius?: number; length?: Axes };
  zero: Axes;
  diameters?: string[];
  feed_per_turn?: number | null;
  surface?: Surface | null;
  tool_offset?: ToolOffset | null;
  variables: Variable[];
  limits?: string | null;
  seconds: number;
  left: number;
}
export interface Pass {
  from: number;
  to: number;
  number: number;
}
export interface Passes {
  passes: Pass[];
  count: number;
}

export type OutlineKind = "program" | "subprogram" | "tool" | "cycle" | "label" | "section";
/// `depth` 0 for a program of the file; the entries inside follow it. `title` says what a cycle does.
export interface OutlineEntry {
  kind: OutlineKind;
  name: string;
  title?: string;
  line: number;
  last: number;
  depth: number;
}
export interface Outline {
  entries: OutlineEntry[];
  more: boolean;
}

export type MarkKind = "tool" | "alarm" | "warning" | "stop" | "optional_stop" | "message" | "zero" | "dwell" | "end";
export interface Mark {
  at: number;
  kind: MarkKind;
  line: number;
  text: string;
}
export interface ToolTime {
  tool: number;
  from: number;
  seconds: number;
  name?: string;
  radius?: number;
  length?: number;
}
/// A joint that moves the part, in the order from the bed to the part: rotates right-handed about the line through
/// `through`, or moves along it; drawn as it is at `from`.
export interface Joint {
  axis: string;
  turns: boolean;
  direction: [number, number, number];
  through: [number, number, number];
  from: number;
}
export interface Done {
  state: "ended" | "stopped" | "cancelled";
  seconds: number;
  blocks: number;
  vertices: number;
  zero: [number, number, number];
  joints: Joint[];
  extents: { cutting: Box | null; all: Box | null };
  distances: { cutting: number; rapid: number };
  times: { cutting: number; rapid: number; dwell: number; tools: number };
  tools: ToolTime[];
  marks: Mark[];
  axes: string[];
  diameters?: string[];
  units: "mm" | "inch";
  unstated?: string;
}
export interface Progress {
  part: number;
  blocks: number;
  seconds: number;
}
