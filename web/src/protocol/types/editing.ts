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
