// One field of an edit: its label, its input and its unit.
import { t } from "../texts/texts";
import { h, option } from "../ui/dom";
import type { EditField } from "./edit_form";

/// The numbers of the tools that the last run has used.
export const tools_of = (used: { tool: number }[]): string[] =>
  [...new Set(used.map((one) => String(one.tool)))].filter((n) => n !== "0");

/// `value`: of the field now; `tools` offered for a field of the kind `tool`; `set` receives each new value.
export function field_row(f: EditField, value: string, tools: string[], set: (value: string) => void): HTMLElement {
  const named = { name: f.name, "aria-label": t(f.text) };
  if (f.kind === "tick") {
    const box = h("input", {
      ...named,
      type: "checkbox",
      checked: value === "on",
      onchange: () => set(box.checked ? "on" : ""),
    });
    return h("label", { class: "tick" }, box, t(f.text));
  }
  const choices = choices_of(f, tools);
  const input: HTMLInputElement | HTMLSelectElement = choices
    ? h(
        "select",
        { ...named, onchange: () => set(input.value) },
        ...choices.map(([name, text]) => option(name, text, name === value)),
      )
    : h("input", {
        ...named,
        value,
        inputmode: f.kind === "text" ? "text" : "decimal",
        placeholder: f.may_be_empty ? t("edit_all_tools") : "",
        autocomplete: "off",
        oninput: () => set(input.value),
      });
  if (choices && input.value !== value) set(input.value);
  return h(
    "label",
    { class: "edit-row" },
    h("span", null, t(f.text)),
    input,
    h("span", { class: "dim" }, f.unit ?? ""),
  );
}

function choices_of(f: EditField, tools: string[]): [string, string][] | null {
  if (f.kind === "choice") return (f.choices ?? []).map(([name, text]) => [name, t(text)]);
  if (f.kind !== "tool" || !tools.length) return null;
  const all: [string, string][] = f.may_be_empty ? [["", t("edit_all_tools")]] : [];
  return [...all, ...tools.map((n) => [n, `T${n}`] as [string, string])];
}
