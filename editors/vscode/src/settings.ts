// The settings of the extension, as the program and the language server take them.
import { homedir } from "node:os";
import { isAbsolute, join } from "node:path";

export interface Settings {
  path: string; // of the program `kadr`
  control: string; // empty: .kadr.toml or a guess decides
  machine: string;
  setup: string; // absolute, or empty
  language: "en" | "ru";
}

/// `get`: a setting by its name without "kadr."; `folder`: of the workspace, if there is one; `editor_language`: of the
/// editor itself, such as "ru" or "en-GB".
export function settings_of(
  get: (name: string) => string | undefined,
  folder: string | undefined,
  editor_language: string,
): Settings {
  const text = (name: string): string => (get(name) ?? "").trim();
  const expanded = (path: string): string =>
    path.replace(/^~(?=\/|$)/, homedir()).replace(/\$\{workspaceFolder\}/g, folder ?? "");
  const setup = expanded(text("setup")),
    language = text("language") || editor_language;
  return {
    path: expanded(text("path")) || "kadr",
    control: text("control"),
    machine: text("machine"),
    setup: setup && !isAbsolute(setup) && folder ? join(folder, setup) : setup,
    language: language.startsWith("ru") ? "ru" : "en",
  };
}

/// The options of the command line that say with what a program runs.
export function choice_words(s: Settings): string[] {
  const words: string[] = [];
  if (s.control) words.push("--control", s.control);
  if (s.machine) words.push("--machine", s.machine);
  if (s.setup) words.push("--setup", s.setup);
  return words;
}

/// What the language server reads (docs/lsp.md).
export function server_settings(s: Settings): Record<string, string> {
  return { control: s.control, machine: s.machine, setup: s.setup, language: s.language };
}

export interface TaskWords {
  command: "check" | "run";
  file?: string; // a program, or for check a folder too
  args?: string[];
}
/// The words of the command line of a task. The control of a folder is that of each of its programs.
export function task_words(d: TaskWords, s: Settings): string[] {
  return [d.command, d.file ?? ".", "--lang", s.language, ...choice_words(s), ...(d.args ?? [])];
}
