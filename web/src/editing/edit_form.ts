// The edits that the page offers: the fields of each, and the words of `kadr edit` that they make.
import type { App } from "../model/app";
import type { EditQuestion, EditWords } from "../protocol/types";
import type { TextKey } from "../texts/texts";

export type EditName =
  | "feed"
  | "speed"
  | "mirror"
  | "rotate"
  | "shift"
  | "copy"
  | "copy_around"
  | "reverse"
  | "renumber"
  | "tidy"
  | "replace_tool"
  | "replace_zero";

export interface EditField {
  name: string;
  text: TextKey;
  unit?: "mm" | "%" | "°";
  kind: "number" | "whole" | "text" | "choice" | "tick" | "tool";
  usual: string; // "": nothing; a field that may be empty has no mark
  may_be_empty?: boolean;
  choices?: [string, TextKey][];
}

const number = (name: string, text: TextKey, unit: EditField["unit"], usual: string): EditField => ({
  name,
  text,
  unit,
  kind: "number",
  usual,
});
const tool: EditField = { name: "tool", text: "edit_tool", kind: "tool", usual: "", may_be_empty: true };
const whole = (name: string, text: TextKey, usual: string): EditField => ({ name, text, kind: "whole", usual });
const tick = (name: string, text: TextKey): EditField => ({ name, text, kind: "tick", usual: "" });
const word = (name: string, text: TextKey, usual: string): EditField => ({ name, text, kind: "text", usual });

export const edits: Record<EditName, EditField[]> = {
  feed: [number("percent", "edit_percent", "%", "80"), tool],
  speed: [number("percent", "edit_percent", "%", "80"), tool],
  mirror: [
    {
      name: "axis",
      text: "edit_mirror_axis",
      kind: "choice",
      usual: "X",
      choices: [
        ["X", "edit_mirror_x"],
        ["Y", "edit_mirror_y"],
      ],
    },
    number("line", "edit_mirror_line", "mm", "0"),
  ],
  rotate: [
    number("degrees", "edit_degrees", "°", "90"),
    number("x", "edit_centre_x", "mm", "0"),
    number("y", "edit_centre_y", "mm", "0"),
  ],
  shift: [
    number("x", "edit_by_x", "mm", "0"),
    number("y", "edit_by_y", "mm", "0"),
    number("z", "edit_by_z", "mm", "0"),
  ],
  copy: [
    whole("columns", "edit_columns", "2"),
    whole("rows", "edit_rows", "1"),
    number("dx", "edit_apart_x", "mm", "50"),
    number("dy", "edit_apart_y", "mm", "0"),
  ],
  copy_around: [
    whole("count", "edit_count", "6"),
    number("step", "edit_angle_step", "°", "60"),
    number("x", "edit_centre_x", "mm", "0"),
    number("y", "edit_centre_y", "mm", "0"),
  ],
  reverse: [whole("from", "edit_from_line", ""), whole("to", "edit_to_line", "")],
  renumber: [whole("first", "edit_first", "10"), whole("step", "edit_step", "10")],
  tidy: [
    tick("numbers", "edit_strip_numbers"),
    tick("comments", "edit_strip_comments"),
    tick("spaces", "edit_strip_spaces"),
    tick("empty-lines", "edit_strip_empty"),
    tick("apart", "edit_add_spaces"),
  ],
  replace_tool: [
    { ...tool, name: "from", text: "edit_old_tool", may_be_empty: false },
    whole("to", "edit_new_tool", ""),
  ],
  replace_zero: [word("from", "edit_old_zero", "G54"), word("to", "edit_new_zero", "G55")],
};

export type EditValues = Record<string, string>;

/// A decimal comma counts as a point; null: no number.
export function figure_of(typed: string): number | null {
  const text = typed.trim().replace(",", ".").replace("−", "-");
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(text) ? Number(text) : null;
}

/// Returns the name of the first field that is wrong; null if none is.
export function wrong_field(edit: EditName, values: EditValues): string | null {
  for (const f of edits[edit]) {
    const typed = (values[f.name] ?? f.usual).trim();
    if (f.kind === "tick" || f.kind === "choice") continue;
    if (!typed) {
      if (f.may_be_empty) continue;
      return f.name;
    }
    if (f.kind === "number" && figure_of(typed) === null) return f.name;
    if ((f.kind === "whole" || f.kind === "tool") && !/^\d+$/.test(typed)) return f.name;
  }
  return null;
}

/// Returns the words of `kadr edit`; null if a field is wrong or nothing is asked for.
export function words_of(edit: EditName, values: EditValues): EditWords | null {
  if (wrong_field(edit, values) !== null) return null;
  const typed = (name: string): string =>
    (values[name] ?? edits[edit].find((f) => f.name === name)?.usual ?? "").trim();
  const figure = (name: string): number => figure_of(typed(name)) ?? 0;
  if (edit === "feed" || edit === "speed")
    return { [edit]: [`${typed("tool") ? `T${typed("tool")}=` : ""}${figure("percent")}%`] };
  if (edit === "mirror") return { mirror: `${typed("axis")}=${figure("line")}` };
  if (edit === "rotate") return { rotate: `${figure("degrees")}@${figure("x")},${figure("y")}` };
  if (edit === "copy") return { copy: `${typed("columns")}x${typed("rows")}:${figure("dx")},${figure("dy")}` };
  if (edit === "copy_around") return { copy: `${typed("count")}@${figure("step")}:${figure("x")},${figure("y")}` };
  if (edit === "reverse") return { reverse: `${typed("from")}-${typed("to")}` };
  if (edit === "renumber") return { renumber: `${typed("first")}:${typed("step")}` };
  if (edit === "replace_tool") return { "replace-tool": [`${typed("from")}=${typed("to")}`] };
  if (edit === "replace_zero") return { "replace-zero": [`${typed("from")}=${typed("to")}`.toUpperCase()] };
  if (edit === "shift") {
    const by = (["x", "y", "z"] as const).filter((axis) => figure(axis) !== 0);
    return by.length ? { shift: by.map((axis) => `${axis.toUpperCase()}${figure(axis)}`) } : null;
  }
  const strip = ["numbers", "comments", "spaces", "empty-lines"].filter((name) => values[name] === "on");
  const made: EditWords = {};
  if (strip.length) made.strip = strip;
  if (values.apart === "on") made.add = "spaces";
  return Object.keys(made).length ? made : null;
}

/// The question for the current text, saved or not, with its choices; null if nothing is open, or nothing is asked for.
export function edit_question(
  app: Pick<App, "opened" | "choice" | "tables" | "text">,
  words: EditWords | null,
): EditQuestion | null {
  if (!app.opened || app.text === null || !words) return null;
  const { control, machine, setup } = app.choice;
  const question: EditQuestion = {
    file: app.opened.file,
    control: control ?? app.opened.control.id,
    text: app.text,
    edits: words,
  };
  if (machine) question.machine = machine;
  if (setup) question.setup = setup;
  if (app.tables?.file === app.opened.file && Object.keys(app.tables.edited).length)
    question.tables = app.tables.edited;
  return question;
}
