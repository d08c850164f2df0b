// The tables of the set-up form: a row for each zero and offset that the program uses or the file states.
import { t, type TextKey } from "../texts/texts";
import type { SetupForm, SetupRow } from "../protocol/types";
import { button, h } from "../ui/dom";
import { column_title } from "./column_titles";
import { number_in, type FormRow, type FormValues } from "./form_values";

/// What a table's fields do.
export interface TableVerbs {
  changed(): void; // a value: the form is not drawn again, so that Tab goes on
  drawn(): void; // rows: the form is drawn again
  line(n: number): void;
}

export function setup_table(table: string, values: FormValues, verbs: TableVerbs): HTMLElement {
  const rows = values.rows(table),
    columns = values.columns(table);
  const name = h("input", {
    size: "7",
    "aria-label": `${t(`table_${table}` as TextKey)}: ${t("tables_new_row")}`,
    placeholder: t("tables_new_row"),
  });
  const add = (): void => {
    const n = name.value.trim();
    if (!n) return;
    values.add_row(table, n);
    verbs.drawn();
  };
  name.addEventListener("keydown", (e) => {
    if (e.key === "Enter") add();
  });
  return h(
    "section",
    { class: "setup-table", "data-table": table },
    h("h3", null, t(`table_${table}` as TextKey)),
    rows.length > 0 &&
      h(
        "div",
        { class: "table-scroll" },
        h(
          "table",
          { class: "table-rows" },
          h(
            "thead",
            null,
            h(
              "tr",
              null,
              h("th", null),
              ...columns.map((c) => {
                const title = column_title(table, c);
                const about = values.form.columns.find((x) => table === "offsets" && x.key === c)?.about;
                return h(
                  "th",
                  { scope: "col", title: about },
                  title.text,
                  title.unit && h("span", { class: "dim" }, ` ${title.unit}`),
                );
              }),
            ),
          ),
          h("tbody", null, ...rows.flatMap((r) => row_lines(table, r, columns, values, verbs))),
        ),
      ),
    h(
      "div",
      { class: "row wrap" },
      name,
      button(t("tables_add"), add),
      rows.length > 0 &&
        button(
          t("zero_all"),
          () => {
            values.set_all(table, "0");
            verbs.drawn();
          },
          { title: t("zero_all_long") },
        ),
    ),
  );
}

/// The tools that the program calls, with what comments tell of them; their shapes are forms of their own.
export function setup_tools(form: SetupForm, line: (n: number) => void, cut: () => void): HTMLElement {
  const tools = form.rows.filter((r) => r.table === "tool");
  const told = (r: SetupRow): string => {
    const why = r.by ?? r.unsure;
    return why ? t(r.by ? "tool_by" : "unsure_by", { line: why.line, text: why.text }) : t("tool_untold");
  };
  return h(
    "section",
    { class: "setup-table", "data-table": "tools" },
    h("h3", null, t("setup_tools")),
    !tools.length && h("p", { class: "note" }, t("tools_not_called")),
    ...tools.map((r) =>
      h(
        "div",
        { class: "why" },
        h("b", null, `T${r.row}`),
        r.diameter !== undefined && ` Ø ${Math.round(1e4 * r.diameter) / 1e4} ${t("mm")}`,
        " ",
        button(t("used_in", { line: r.line }), () => line(r.line), { class: "link use", title: t("show_line") }),
        h("span", { class: "dim" }, told(r)),
      ),
    ),
    h("div", { class: "row wrap" }, button(t("setup_to_cut"), cut)),
  );
}

function row_lines(
  table: string,
  row: FormRow,
  columns: string[],
  values: FormValues,
  verbs: TableVerbs,
): HTMLElement[] {
  const comment = row.uses.find((use) => use.by ?? use.unsure);
  const why = comment?.by ?? comment?.unsure;
  const told = why && t(comment?.by ? "proposed_by" : "unsure_by", { line: why.line, text: why.text });
  return [
    h(
      "tr",
      null,
      h("th", { scope: "row" }, row.name),
      ...columns.map((c) => h("td", null, field(table, row, c, values, verbs))),
    ),
    h(
      "tr",
      { class: "why" },
      h(
        "td",
        { colspan: columns.length + 1 },
        ...row.uses.map((use) => use_told(use, row, verbs)),
        !row.uses.length && h("span", { class: "dim" }, t("not_used")),
        why && button(told ?? "", () => verbs.line(why.line), { class: "link note", title: t("show_line") }),
      ),
    ),
  ];
}

/// "H1 T1 line 11": the word that uses the row, and where.
function use_told(use: SetupRow, row: FormRow, verbs: TableVerbs): HTMLElement {
  const at = use.file_name
    ? t("used_in_file", { line: use.line, file: use.file_name })
    : t("used_in", { line: use.line });
  const word = use.word.startsWith("offsets.") ? t("column_radius") : use.word === row.name ? "" : use.word;
  const tool = row.uses[0]?.table === "offsets" && use.tool && !word.startsWith("T") ? `T${use.tool}` : "";
  const text = [word, tool, at].filter(Boolean).join(" ");
  if (use.file_name) return h("span", { class: "dim use" }, text);
  return button(text, () => verbs.line(use.line), { class: "link use", title: t("show_line") });
}

function field(table: string, row: FormRow, column: string, values: FormValues, verbs: TableVerbs): HTMLElement {
  const input = h("input", { size: "8", inputmode: "decimal", autocomplete: "off" });
  const draw = (): void => {
    const { text, origin } = values.value(table, row.name, column);
    const used = row.uses.some((use) => use.cells.some((c) => c.key === column));
    input.value = text;
    const wrong = text !== "" && origin === "typed" && number_in(text) === null;
    const open = origin === "open" && used && !column.endsWith("_wear");
    input.className = wrong ? "wrong" : origin !== "open" ? origin : open ? "open" : "";
    input.setAttribute("aria-invalid", String(wrong));
    input.title = wrong ? t("no_number") : t(`origin_${origin}` as TextKey);
  };
  const title = column_title(table, column);
  input.setAttribute("aria-label", `${row.name} ${title.text}`.trim());
  input.addEventListener("input", () => {
    values.set(table, row.name, column, input.value);
    verbs.changed();
  });
  input.addEventListener("change", draw);
  draw();
  return input;
}
