// The rows of a machine's tables: values of the set-up file, edits made here, changes by the program.
import type { Operator } from "../model/operator";
import type { Json, JsonTable, Tables } from "../protocol/types";
import { column_title } from "../setup/column_titles";
import { t, type TextKey } from "../texts/texts";
import { button, h } from "./dom";

/// `take`: what was typed into a field; `edit`: any other change.
export interface TableEdits {
  take(input: HTMLInputElement, tables: JsonTable): Promise<void>;
  edit(tables: JsonTable): void;
}

const offset_columns = ["length", "length_wear", "radius", "radius_wear"];
const lathe_columns = ["X", "X_wear", "Z", "Z_wear", "radius", "radius_wear", "tip"];
/// A lathe's tools have a length along each axis.
const columns_of_offsets = (operator: Operator): string[] =>
  operator.panel?.diameters?.length ? lathe_columns : offset_columns;
const of_rows = ["work_offsets", "zeros", "offsets", "tool_table", "form_table"]; // a row has columns; the others have one value per row

const first_row: Record<string, string> = { work_offsets: "G54", variables: "#500" };

export const table = (of: Json | undefined): JsonTable =>
  of && typeof of === "object" && !Array.isArray(of) ? of : {};
const shown = (v: Json | undefined): string =>
  v === undefined || v === null ? "" : typeof v === "object" ? JSON.stringify(v) : String(v);

const zeroed = ["work_offsets", "zeros", "offsets", "correctors"]; // tables of lengths

/// The title of a column in words, with its unit.
function titled(section: string, column: string): (string | HTMLElement)[] {
  const { text, unit } = column_title(section, column);
  return unit ? [text, h("span", { class: "dim" }, ` ${unit}`)] : [text];
}
function zeros(rows: string[], columns: string[] | null): JsonTable {
  return Object.fromEntries(rows.map((r) => [r, columns ? Object.fromEntries(columns.map((c) => [c, 0])) : 0]));
}

/// The rows of any table but that of the variables.
export function table_rows(
  s: Tables,
  section: string,
  operator: Operator,
  may: boolean,
  verbs: TableEdits,
): HTMLElement {
  const of_file = table(s.file[section]),
    edited = table(s.edited[section]),
    now = table(s.now[section]);
  const names = [...new Set([...Object.keys(of_file), ...Object.keys(edited), ...Object.keys(now)])].sort((a, b) =>
    a.localeCompare(b, "en", { numeric: true }),
  );
  const by_columns = of_rows.includes(section);
  const columns = !by_columns
    ? []
    : section === "offsets"
      ? columns_of_offsets(operator)
      : ["work_offsets", "zeros"].includes(section)
        ? operator.axes
        : [...new Set(names.flatMap((n) => [...Object.keys(table(of_file[n])), ...Object.keys(table(edited[n]))]))];
  const cell = (row: string, column: string | null): HTMLElement => {
    const from = column === null ? of_file[row] : table(of_file[row])[column],
      here = column === null ? edited[row] : table(edited[row])[column],
      live = column === null ? undefined : table(now[row])[column];
    const value = here ?? from,
      other = live !== undefined && Number(live) !== Number(value ?? 0);
    const where = other
      ? t("from_program", { value: shown(live) })
      : here !== undefined
        ? t("from_here", { value: shown(from) || "0" })
        : from !== undefined
          ? t("from_setup")
          : "";
    const input = h("input", {
      size: "9",
      inputmode: "decimal",
      disabled: !may,
      class: here !== undefined ? "edited" : other ? "by-program" : "",
      title: where,
      "aria-label": `${t(`table_${section}` as TextKey)} ${row} ${column ?? ""} ${where}`.trim(),
      value: shown(value),
      onchange: () =>
        void verbs.take(input, {
          [section]: { [row]: column === null ? read_value(input.value) : { [column]: read_value(input.value) } },
        }),
    });
    return h("td", null, input);
  };
  const name = h("input", { size: "8", "aria-label": t("tables_new_row"), placeholder: t("tables_new_row") });
  const add = (): void => {
    const n = name.value.trim();
    name.value = "";
    if (n) verbs.edit({ [section]: { [n]: by_columns ? { [columns[0] ?? "X"]: 0 } : 0 } });
  };
  return h(
    "div",
    { class: "table-scroll" },
    !names.length && h("p", { class: "note" }, t("table_none", { row: first_row[section] ?? "1" })),
    h(
      "table",
      { class: "table-rows" },
      by_columns &&
        h(
          "thead",
          null,
          h("tr", null, h("th", null), ...columns.map((c) => h("th", { scope: "col" }, ...titled(section, c)))),
        ),
      h(
        "tbody",
        null,
        ...names.map((n) =>
          h(
            "tr",
            null,
            h("th", { scope: "row" }, n),
            ...(by_columns ? columns.map((c) => cell(n, c)) : [cell(n, null)]),
          ),
        ),
      ),
    ),
    h(
      "div",
      { class: "row" },
      name,
      button(t("tables_add"), add, { disabled: !may }),
      names.length > 0 &&
        zeroed.includes(section) &&
        button(t("zero_all"), () => verbs.edit({ [section]: zeros(names, by_columns ? columns : null) }), {
          disabled: !may,
          title: t("zero_all_long"),
        }),
    ),
  );
}

export function table_variables(s: Tables, may: boolean, verbs: TableEdits): HTMLElement {
  const of_file = table(s.file["variables"]),
    edited = table(s.edited["variables"]),
    live = new Map(s.variables.map((v) => [v.name, v]));
  const names = [...new Set([...live.keys(), ...Object.keys(of_file), ...Object.keys(edited)])].sort((a, b) =>
    a.localeCompare(b, "en", { numeric: true }),
  );
  const name = h("input", { size: "8", "aria-label": t("tables_new_row"), placeholder: "#500" }),
    value = h("input", { size: "8", "aria-label": t("value"), inputmode: "decimal" });
  return h(
    "div",
    { class: "table-scroll" },
    !names.length && h("p", { class: "note" }, t("table_none", { row: first_row["variables"]! })),
    h(
      "table",
      { class: "table-rows" },
      h(
        "tbody",
        null,
        ...names.map((n) => {
          const v = live.get(n),
            input = h("input", {
              size: "12",
              inputmode: "decimal",
              disabled: !may,
              "aria-label": `${t("force_variable")} ${n}`,
              class: edited[n] !== undefined ? "edited" : "",
              value: shown(v?.value ?? edited[n] ?? of_file[n]),
              onchange: () => void verbs.take(input, { variables: { [n]: read_value(input.value) } }),
            });
          return h(
            "tr",
            null,
            h("th", { scope: "row" }, n),
            h("td", null, input),
            h(
              "td",
              { class: "dim" },
              v?.line
                ? t("set_by_line", { line: v.line })
                : edited[n] !== undefined
                  ? t("from_here", { value: shown(of_file[n]) || "–" })
                  : of_file[n] !== undefined
                    ? t("from_setup")
                    : "",
            ),
          );
        }),
      ),
    ),
    h(
      "div",
      { class: "row" },
      name,
      value,
      button(
        t("tables_add"),
        () => {
          const n = name.value.trim(),
            v = read_value(value.value) ?? 0;
          name.value = value.value = "";
          if (n) verbs.edit({ variables: { [n]: v } });
        },
        { disabled: !may },
      ),
    ),
  );
}

/// null removes an edit.
export function read_value(text: string): Json {
  const s = text.trim().replace(",", ".");
  if (s === "") return null;
  return Number.isFinite(Number(s)) ? Number(s) : text.trim();
}
