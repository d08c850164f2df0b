// Converting a program for another control: the question, and the names under which the answer is saved.
import type { ConversionTry, ConvertQuestion } from "../protocol/types";
import type { App } from "./app";

export interface ConvertForm {
  to: string;
  flat: boolean;
  force: boolean;
}

/// The question for the current text, saved or not, with its choices; null if no control is chosen, or nothing is
/// open.
export function conversion_of(
  app: Pick<App, "opened" | "choice" | "tables" | "dirty" | "text">,
  form: ConvertForm,
): ConvertQuestion | null {
  if (!app.opened || !form.to) return null;
  const { control, machine, setup } = app.choice;
  const question: ConvertQuestion = { file: app.opened.file, control: control ?? app.opened.control.id, to: form.to };
  if (machine) question.machine = machine;
  if (setup) question.setup = setup;
  if (app.tables?.file === app.opened.file && Object.keys(app.tables.edited).length)
    question.tables = app.tables.edited;
  if (app.dirty && app.text !== null) question.text = app.text;
  if (form.flat) question.flat = true;
  if (form.force) question.force = true;
  return question;
}

/// The set-up of a program is next to it, under the program's name.
export const setup_name_of = (program: string): string => `${program.replace(/\.[^./]*$/, "")}.json`;
/// An empty set-up needs no file.
export const says_something = (setup: string): boolean => !/^\s*\{\s*\}\s*$/.test(setup);

/// Returns the beginning of a text, whole lines; `more` is the number of lines left out.
export function beginning_of(text: string, most: number): { text: string; more: number } {
  if (text.length <= most) return { text, more: 0 };
  const end = text.lastIndexOf("\n", most) + 1 || most;
  return {
    text: text.slice(0, end),
    more: text
      .slice(end)
      .split("\n")
      .filter((line, i, all) => line !== "" || i < all.length - 1).length,
  };
}

/// Groups the rejected ways of writing by the reason that forbids them.
export function by_reason(tries: ConversionTry[]): { ways: string[]; one: ConversionTry }[] {
  const groups: { ways: string[]; one: ConversionTry }[] = [];
  const reason = ({ as: _, way: __, ...of }: ConversionTry): string => JSON.stringify(of);
  for (const one of tries) {
    const last = groups.at(-1);
    if (last && reason(last.one) === reason(one)) last.ways.push(one.way);
    else groups.push({ ways: [one.way], one });
  }
  return groups;
}
