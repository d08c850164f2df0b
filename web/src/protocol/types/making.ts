// Messages of docs/panel-protocol.md: new programs, tapes, conversions.
import type { OpenQuestion, Problem } from "./program";

export type MillTask = "pocket" | "face" | "slot";
/// The question to `kadr mill`, by the names of its options; omitted options have their usual values.
export interface MillQuestion {
  drawing: string;
  control: string;
  task: MillTask;
  tool_diameter: number;
  depth: number;
  pass?: number;
  allowance?: number;
  top?: number;
  scheme?: string;
  direction?: string;
  stepover?: string;
  plunge?: string;
  hole?: [number, number];
  ramp_angle?: number;
  clearance?: number;
  overrun?: number;
  angle?: number;
  width?: number;
  feed?: number;
  plunge_feed?: number;
  speed?: number;
  tool?: number;
  coolant?: boolean;
  mark?: string;
}
/// `picture` SVG, "": too large to be shown; `warning` "": none; `name`: a file name that is not in use.
export interface Milled {
  text: string;
  picture: string;
  summary: { name: string; value: string }[];
  warning: string;
  name: string;
}
/// `word` of the question that is wrong, "": the drawing is.
export interface NotMilled {
  problem: Problem;
  word: string;
  line_text: string;
}
/// `bytes` in base64: one byte per row.
export interface Punched {
  bytes: string;
  rows: number;
  name: string;
}
export type TapeCode = "iso" | "eia";
export interface TapeRead {
  text: string;
  code: TapeCode;
  lies: string;
  faults: string[];
  more: number;
  name: string;
}

/// A program with the contents of `open`; `to` is the control to convert it for.
export type ConvertQuestion = OpenQuestion & { to: string; flat?: boolean; force?: boolean };
/// A rejected way of writing the program. `line` 0: at no line of the program; `file` 0: the program itself;
/// `written_line`: line of the text written for the other control, 0: none.
export interface ConversionTry {
  as: string;
  way: string;
  text: string;
  line: number;
  file: number;
  file_name: string;
  line_text: string;
  written_line: number;
  written_text: string;
}
export interface Converted {
  text: string;
  tolerance: number;
  written: {
    proven: boolean;
    as: string;
    way: string;
    program: string;
    setup: string;
    name: string;
    note: string;
    written_out: { from: number; to: number; text: string }[];
  } | null;
  tries: ConversionTry[];
}
