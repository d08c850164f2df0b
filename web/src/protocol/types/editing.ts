// Messages of docs/panel-protocol.md: edits of a program, each with its proof.
import type { OpenQuestion } from "./program";

/// The names of the options of `kadr edit` without hyphens, with their words: {"feed": ["T3=80%"]}.
export type EditWords = Record<string, string | string[]>;
export interface EditQuestion extends OpenQuestion {
  edits: EditWords;
}
/// `text` "": refused; `line` 0: the reason belongs to no line of the program.
export interface EditedProgram {
  text: string;
  lines: number;
  told: string;
  note: string;
  refused: { text: string; line: number }[];
}

export interface CycleRow {
  code: string;
  title: string;
  words: { letter: string; needed: boolean }[];
}
export type Point = [number, number];
/// Figures in the unit of the program. `motion`: the code that is to be in force after the blocks; `after`: the line that they
/// follow, for their numbers.
export type BlocksQuestion = ({ what: "cycles" } | WrittenFigures) & { motion?: string; after?: number };
type WrittenFigures =
  | {
      what: "cycle";
      code: string;
      retract: string;
      values: Record<string, number>;
      holes: Point[];
      unit: "mm" | "inch";
    }
  | { what: "arc"; from: Point; through: Point; to: Point; unit: "mm" | "inch" }
  | {
      what: "corner";
      kind: "chamfer" | "rounding";
      size: number;
      from: Point;
      corner: Point;
      to: Point;
      unit: "mm" | "inch";
    };
export interface WrittenBlocks {
  cycles: CycleRow[];
  retract: { code: string; title: string }[];
  lines: string[];
}
