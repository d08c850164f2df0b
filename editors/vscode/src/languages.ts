// The languages of programs: `nc`, and `nc-` with the id of a control (dev/grammars).
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";

export const is_program = (language: string): boolean => /^nc(-|$)/.test(language);

/// Returns the control that the nearest `.kadr.toml` names for all programs of its folder (docs/own-control.md); empty:
/// none. The program itself reads that file too: this only chooses the colours.
export function control_of_folder(program: string): string {
  for (let folder = dirname(program); ; folder = dirname(folder)) {
    const file = join(folder, ".kadr.toml");
    if (existsSync(file)) return /^control\s*=\s*"([^"]*)"/m.exec(readFileSync(file, "utf8"))?.[1] ?? "";
    if (folder === dirname(folder)) return "";
  }
}

/// Returns the language for a program of this control. `known`: the languages of the editor.
export function language_of(control: string, known: readonly string[]): string {
  const named = `nc-${control}`;
  return control && known.includes(named) ? named : "nc";
}

/// Returns the language for a program whose control the server has found. Only a program that has no control's colours
/// yet gets them: others were chosen by the user, a setting or the name of the file.
export function language_found(present: string, control: string, known: readonly string[]): string {
  return present === "nc" ? language_of(control, known) : present;
}

/// Reads what `kadr controls` prints: an id and a name in each line.
export function controls_in(printed: string): { id: string; name: string }[] {
  return printed
    .split("\n")
    .map((line) => /^(\S+)\s{2,}(.*)$/.exec(line))
    .filter((m) => m !== null)
    .map((m) => ({ id: m[1]!, name: m[2]! }));
}
