// Messages of docs/panel-protocol.md: the panel of a machine, restart and tables.
import type { Axes, JsonTable } from "./base";
import type { Call, Modal, Problem, Surface, ToolOffset } from "./program";

/// Each question, with its contents and its answer.
export type PanelMode = "standing" | "running" | "held" | "ended" | "alarm" | "emergency";
export type PanelKey =
  "run" | "hold" | "reset" | "emergency" | "take" | "off" | "block" | "over" | "out" | "home" | "unlock";
export interface StopPoint {
  number: number;
  line: number;
  pass: number;
  call: string;
  condition: string;
  tool: number;
}
/// A machine at its panel: positions are a sample of the servo clock.
export interface Panel {
  mode: PanelMode;
  instant: number;
  position: Axes;
  machine: Axes;
  togo: Axes;
  feed: number;
  speed: number;
  share: number;
  override: number;
  rapid: number;
  spindle: number;
  dry_feed: number;
  asks: boolean;
  takes_tables: boolean;
  not_kept: string;
  line: number;
  file: number;
  text: string;
  number: number;
  entered: boolean;
  single: boolean;
  optional_stop: boolean;
  skip: number[];
  stops: StopPoint[];
  hit: number;
  told: string;
  why: string; // "", "M0", "M1", "restart"; on a real machine also "M6", "M21" …
  stop_line?: number; // of the program, with the code of `why`
  stop_text?: string;
  goes_there: boolean;
  can_undo: number;
  blocks: number;
  modal: Modal[];
  rpm: number | null;
  tool: number | null;
  offsets: { T?: number | null; D?: number | null; H?: number | null };
  zero: Axes;
  diameters?: string[];
  feed_per_turn?: number | null;
  surface?: Surface | null;
  tool_offset?: ToolOffset | null;
  calls: Call[];
  alarm: Problem | null;
  holds: boolean;
  held: boolean;
  limit: string;
  channels: PanelChannel[];
  digest: string; // of the program text that the machine runs
  real?: RealMachine | null; // null: the machine is virtual
}
/// A real machine: what its controller reports. `age` of the position and `pending` in s: how long the axes would go on
/// moving if the connection broke now.
export interface RealMachine {
  port: string;
  controller: string;
  state: string;
  inputs: string;
  age: number;
  pending: number;
  lost: boolean;
  locked: boolean;
}
export interface ProofRow {
  id: string;
  what: string;
  controller: string;
  program: string;
  verdict: "equal" | "note" | "refused";
  why: string;
}
/// A program compared with a connected controller; `first`: the first motion, machine coordinates.
export interface Proof {
  rows: ProofRow[];
  lines: number;
  stops: number;
  seconds: number;
  first: { line: number; text: string; from: Axes; to: Axes } | null;
  controller: string;
  locked: boolean;
}
/// One of several channels; `waits`: its axes have reached a waiting code, which of the required channels (`channels`)
/// have too (`here`).
export interface PanelChannel {
  number: number;
  axes: string[];
  position: Axes;
  machine: Axes;
  diameters?: string[];
  feed: number;
  speed: number;
  moves: boolean;
  line: number;
  text: string;
  waits: { code: number; channels: number[]; here: number[] } | null;
}

/// Where a program restarts; `number` of the block in the run, `hole` of a canned cycle.
export interface RestartPlace {
  line?: number;
  pass?: number;
  of_file?: string;
  call?: string;
  condition?: string;
  number?: number;
  hole?: number;
}
export type ForceKind =
  | "position"
  | "machine"
  | "code"
  | "feed"
  | "speed"
  | "spindle"
  | "coolant"
  | "tool"
  | "selected"
  | "offset"
  | "length_offset"
  | "origin"
  | "length"
  | "rotation"
  | "scale"
  | "variable";
export interface RestartRow {
  key: string;
  kind: ForceKind;
  name: string;
  wanted: string | number | null;
  now: string | number | null;
  by: "" | "way" | "line" | "memory";
  may_be_left: boolean;
}
/// Machine coordinates of the axes that move, at the end of the step.
export interface WayPoint {
  rapid: boolean;
  to: Axes;
  feed: number;
}
export interface SearchCode {
  text: string;
  line: number;
}
/// `zero`: machine coordinates minus work coordinates at that position; `search`: the control's own.
export interface RestartSheet {
  ready: true;
  line: number;
  file: string;
  text: string;
  calls: Call[];
  rows: RestartRow[];
  way: WayPoint[];
  normal: string;
  zero: Axes;
  blocks: string[];
  by_hand: string;
  search: { carried_out: SearchCode[]; of_no_group: SearchCode[]; forgotten: string } | null;
  number: number;
  beside: BesideSheet[];
}
/// For another channel: its position at the restart, keys prefixed with its number; `number` of the sheet is the own
/// channel's.
export interface BesideSheet {
  number: number;
  line: number;
  text: string;
  stands: "before" | "within" | "waits" | "over";
  rows: RestartRow[];
  way: WayPoint[];
  zero: Axes;
  blocks: string[];
  by_hand: string;
}
/// The approach of one channel; the approaches are executed one after the other.
export interface ChannelWay {
  channel: number;
  way: WayPoint[];
}

/// Values of the set-up file, edits, and values from the control; variables with the line that set them (0: not set by
/// the program).
export interface Tables {
  sections: string[];
  setup: string;
  file: JsonTable;
  edited: JsonTable;
  now: JsonTable;
  variables: { name: string; value: number | null; line: number }[];
  lasts: boolean;
}
export interface LogEntry {
  at: string;
  kind: string;
  text: string;
  line: number;
}
export interface Stood {
  mode: PanelMode;
  number: number;
  line: number;
  file: string;
  text: string;
  machine: number[];
}
