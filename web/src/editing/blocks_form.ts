// The blocks that the page can write from figures: the fields of each kind, and the question that they make.
import type { BlocksQuestion, CycleRow, Point, State } from "../protocol/types";
import { figure_of } from "./edit_form";

export type BlocksKind = "cycle" | "arc" | "corner";
export const kinds: BlocksKind[] = ["cycle", "arc", "corner"];
/// What was typed, by the name of the field.
export type BlocksValues = Record<string, string>;

/// "10 20": a position per line; null if a line is none.
export function holes_of(typed: string): Point[] | null {
  const holes: Point[] = [];
  for (const line of typed.split("\n")) {
    const words = line
      .trim()
      .replace(/[XxYy]/g, " ")
      .trim()
      .split(/[\s;]+/);
    if (words.length === 1 && words[0] === "") continue;
    const point = words.map((word) => figure_of(word));
    if (point.length !== 2 || point.includes(null)) return null;
    holes.push(point as Point);
  }
  return holes.length ? holes : null;
}

/// The question for the blocks; null while a field is empty or wrong.
export function blocks_question(
  kind: BlocksKind,
  values: BlocksValues,
  cycle: CycleRow | undefined,
  unit: "mm" | "inch",
): BlocksQuestion | null {
  const point = (name: string): Point | null => {
    const x = figure_of(values[`${name}_x`] ?? ""),
      y = figure_of(values[`${name}_y`] ?? "");
    return x === null || y === null ? null : [x, y];
  };
  if (kind === "cycle") {
    const holes = holes_of(values.holes ?? "");
    if (!cycle || !holes) return null;
    const figures: Record<string, number> = {};
    for (const { letter, needed } of cycle.words) {
      const typed = (values[letter] ?? "").trim(),
        figure = figure_of(typed);
      if (figure !== null) figures[letter] = figure;
      else if (needed || typed) return null;
    }
    return { what: "cycle", code: cycle.code, retract: values.retract ?? "", values: figures, holes, unit };
  }
  const from = point("from"),
    to = point("to");
  if (!from || !to) return null;
  if (kind === "arc") {
    const through = point("through");
    return through && { what: "arc", from, through, to, unit };
  }
  const corner = point("corner"),
    size = figure_of(values.size ?? "");
  if (!corner || size === null || size <= 0) return null;
  return { what: "corner", kind: values.kind === "chamfer" ? "chamfer" : "rounding", size, from, corner, to, unit };
}

/// The text with lines after line `after` (from 1; 0: at the beginning).
export function with_lines(text: string, after: number, lines: string[]): string {
  const all = text.split("\n");
  all.splice(after, 0, ...lines);
  return all.join("\n");
}

/// The motion code in force after a line, which the blocks put in force again: the lines after them may rely on it; null if
/// the state is of another line, or the code in force is no line.
export function motion_at(state: Pick<State, "line" | "file" | "modal"> | null, line: number): string | null {
  if (!state || state.line !== line || (state.file ?? 0) !== 0) return null;
  return state.modal.map((m) => m.code).find((code) => /^G0?[01]$/.test(code)) ?? null;
}
