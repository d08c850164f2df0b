// Messages of docs/panel-protocol.md: the set-up form of a program.
import type { JsonTable } from "./base";

/// A value, or a row of values, of the set-up that the program uses.
export interface SetupRow {
  table: string; // "offsets", "work_offsets" …; "skip", "optional_stop", "tool"
  row: string; // "1", "G54", "#500"; the number of a switch or a tool
  word: string; // that uses it: "H1", "G54"
  line: number; // of the first use
  file_name?: string; // of the first use, if it is not the program
  tool?: number; // in the spindle
  cells: { key: string; proposed?: number }[]; // key "": the row is one value
  diameter?: number;
  by?: { line: number; text: string }; // the comment that states the size
  unsure?: { line: number; text: string }; // a comment that describes the tool without a certain size
}
export interface SetupForm {
  file: string;
  digest: string | null; // of the file on the disk; null: it does not exist yet
  in_force: boolean; // the program was opened with it
  stated: JsonTable; // the file
  setups: string[]; // set-ups next to the program
  tables: string[]; // that a set-up of this control may have
  columns: { key: string; about: string; unit: string }[]; // of the offset table
  axes: string[];
  rows: SetupRow[];
  faults: number;
  not_executed: [number, number][];
}
