// Tables of a machine: values of the set-up file, edits made here, changes by the program. Edits are in force at once.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { Json, JsonTable, Tables } from "../protocol/types";
import { on_language, t, type TextKey } from "../texts/texts";
import { button, fill, h, option, redraw } from "./dom";
import { axis_name, factor, no_diameters } from "../model/diameters";
import { toast } from "./toast";

const offset_columns = ["length", "length_wear", "radius", "radius_wear"];
const lathe_columns = ["X", "X_wear", "Z", "Z_wear", "radius", "radius_wear", "tip"];
/// A lathe's tools have a length along each axis.
const columns_of_offsets = (operator: Operator): string[] =>
  operator.panel?.diameters?.length ? lathe_columns : offset_columns;
const of_rows = ["work_offsets", "zeros", "offsets", "tool_table", "form_table"]; // a row has columns; the others have one value per row

const table = (of: Json | undefined): JsonTable => (of && typeof of === "object" && !Array.isArray(of) ? of : {});
const shown = (v: Json | undefined): string =>
  v === undefined || v === null ? "" : typeof v === "object" ? JSON.stringify(v) : String(v);

export class TablesPanel {
  readonly element = h("details", { class: "tables" });
  private body = h("div");
  private tables: Tables | null = null;
  private section = "";
  private asking = false;
  private told = "{}"; // the edits, as last reported

  /// `changed`: the edits, to be laid over the set-up wherever the program runs.
  constructor(
    private app: App,
    private operator: Operator,
    private changed: (edited: JsonTable) => void,
  ) {
    fill(
      this.element,
      h("summary", null, h("b", null, t("tables")), " ", h("span", { class: "dim" }, t("in_mm"))),
      this.body,
    );
    this.element.addEventListener("toggle", () => void this.load());
    operator.on_panel.on((p) => {
      this.element.hidden = !p;
      if (!p) {
        this.tables = null;
        this.told = "{}";
      } else if (!this.tables) void this.load();
    });
    operator.on_stood.on(() => void this.load());
    on_language(() => {
      fill(
        this.element,
        h("summary", null, h("b", null, t("tables")), " ", h("span", { class: "dim" }, t("in_mm"))),
        this.body,
      );
      this.draw();
    });
    this.element.hidden = true;
  }

  async load(): Promise<void> {
    if (this.asking || !this.operator.panel) return;
    this.asking = true;
    this.tables = await this.operator.ask("tables", {}, false);
    this.asking = false;
    const edited = JSON.stringify(this.tables?.edited ?? {});
    if (this.tables && edited !== this.told) {
      this.told = edited;
      this.changed(this.tables.edited);
    }
    if (this.tables && !this.tables.sections.includes(this.section)) this.section = this.tables.sections[0] ?? "";
    this.draw();
  }

  /// Sends what was typed; then the field shows the table's value, whether it was accepted or refused.
  private async take(input: HTMLInputElement, tables: JsonTable): Promise<void> {
    input.value = input.defaultValue;
    await this.edit(tables);
  }

  private async edit(tables: JsonTable): Promise<void> {
    await this.operator.ask("edit", { tables });
    await this.load();
  }

  private draw(): void {
    redraw(this.body, () => this.fill_body());
  }

  private fill_body(): void {
    const { tables: s } = this,
      p = this.operator.panel;
    if (!s || !p) return fill(this.body);
    const may = p.holds && ["standing", "ended"].includes(p.mode);
    const choose = h(
      "select",
      {
        "aria-label": t("tables"),
        onchange: () => {
          this.section = choose.value;
          this.draw();
        },
      },
      ...s.sections.map((n) => option(n, t(`table_${n}` as TextKey), n === this.section)),
    );
    const edited = Object.keys(s.edited).length > 0,
      into = s.setup || (this.operator.name ?? "").replace(/\.[^./]*$/, ".json");
    fill(
      this.body,
      h(
        "div",
        { class: "row wrap" },
        choose,
        button(t("tables_again"), () => void this.load()),
        edited && button(t("tables_keep", { file: into }), () => void this.keep(into), { disabled: !may }),
        edited &&
          button(
            t("tables_back"),
            () => void this.edit(Object.fromEntries(Object.keys(s.edited).map((k) => [k, null]))),
            { disabled: !may },
          ),
      ),
      (p.diameters ?? []).length > 0 && h("p", { class: "note" }, t("tables_radii", { axes: p.diameters!.join(", ") })),
      !s.lasts && h("p", { class: "note" }, t("tables_not_kept")),
      this.section === "variables" ? this.variables(s, may) : this.rows(s, may),
      this.section === "offsets" &&
        h(
          "div",
          { class: "row" },
          button(t("tables_propose"), () => void this.propose(s), { disabled: !may, title: t("tables_propose_long") }),
        ),
      this.section === "work_offsets" && this.touch_off(may),
    );
  }

  private rows(s: Tables, may: boolean): HTMLElement {
    const of_file = table(s.file[this.section]),
      edited = table(s.edited[this.section]),
      now = table(s.now[this.section]);
    const names = [...new Set([...Object.keys(of_file), ...Object.keys(edited), ...Object.keys(now)])].sort((a, b) =>
      a.localeCompare(b, "en", { numeric: true }),
    );
    const by_columns = of_rows.includes(this.section);
    const columns = !by_columns
      ? []
      : this.section === "offsets"
        ? columns_of_offsets(this.operator)
        : ["work_offsets", "zeros"].includes(this.section)
          ? this.operator.axes
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
        "aria-label": `${t(`table_${this.section}` as TextKey)} ${row} ${column ?? ""} ${where}`.trim(),
        value: shown(value),
        onchange: () =>
          void this.take(input, {
            [this.section]: { [row]: column === null ? this.read(input.value) : { [column]: this.read(input.value) } },
          }),
      });
      return h("td", null, input);
    };
    const name = h("input", { size: "8", "aria-label": t("tables_new_row"), placeholder: t("tables_new_row") });
    const add = (): void => {
      const n = name.value.trim();
      name.value = "";
      if (n) void this.edit({ [this.section]: { [n]: by_columns ? { [columns[0] ?? "X"]: 0 } : 0 } });
    };
    return h(
      "div",
      { class: "table-scroll" },
      h(
        "table",
        { class: "table-rows" },
        by_columns &&
          h("thead", null, h("tr", null, h("th", null), ...columns.map((c) => h("th", { scope: "col" }, c)))),
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
      h("div", { class: "row" }, name, button(t("tables_add"), add, { disabled: !may })),
    );
  }

  private variables(s: Tables, may: boolean): HTMLElement {
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
                onchange: () => void this.take(input, { variables: { [n]: this.read(input.value) } }),
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
              v = this.read(value.value) ?? 0;
            name.value = value.value = "";
            if (n) void this.edit({ variables: { [n]: v } });
          },
          { disabled: !may },
        ),
      ),
    );
  }

  /// The work offset in force, which can be shifted; null if there is none in this table.
  zero(): { code: string; shift(axis: string, by: number): void } | null {
    const s = this.tables,
      code = this.operator.panel?.modal.find((m) => /^G5[4-9]$/.test(m.code))?.code;
    if (!s || !code || !s.sections.includes("work_offsets")) return null;
    const shift = (axis: string, by: number): void => {
      const old =
        table(table(s.edited["work_offsets"])[code])[axis] ?? table(table(s.file["work_offsets"])[code])[axis] ?? 0;
      void this.edit({ work_offsets: { [code]: { [axis]: Math.round(1e6 * (Number(old) + by)) / 1e6 } } });
    };
    return { code, shift };
  }

  /// Shifts the work offset in force so that the tool's position reads the wanted value.
  private touch_off(may: boolean): HTMLElement | false {
    const p = this.operator.panel!,
      zero = this.zero(),
      of = p.diameters ?? no_diameters;
    if (!zero) return false;
    const axis = h(
        "select",
        { "aria-label": t("axis") },
        ...this.operator.axes.map((a) => option(a, axis_name(a, of), false)),
      ),
      wanted = h("input", { size: "8", value: "0", inputmode: "decimal", "aria-label": t("value") });
    const go = (): void => {
      const a = axis.value,
        v = this.read(wanted.value);
      if (typeof v === "number" && p.position[a] !== undefined) zero.shift(a, p.position[a]! - v / factor(a, of));
    };
    return h(
      "div",
      { class: "row" },
      h("span", null, t("touch_off", { code: zero.code })),
      axis,
      h("span", null, "="),
      wanted,
      button(t("touch_off_set"), go, { disabled: !may || p.takes_tables }),
    );
  }

  /// Proposes radii and lengths from tools files and comments, where the table has none.
  private async propose(s: Tables): Promise<void> {
    let found;
    try {
      found = await this.app.client.ask("proposals", {});
    } catch {
      return;
    }
    const offsets: JsonTable = {};
    for (const tool of found.tools) {
      const row = String(tool.number),
        has = { ...table(table(s.file["offsets"])[row]), ...table(table(s.edited["offsets"])[row]) };
      if (tool.diameter && !has["radius"] && tool.known !== false) offsets[row] = { radius: tool.diameter / 2 };
    }
    if (Object.keys(offsets).length) await this.edit({ offsets });
    else toast(t("tables_nothing"));
  }

  private async keep(file: string): Promise<void> {
    if (await this.operator.ask("keep_tables", { setup: file })) toast(t("tables_kept", { file }));
  }

  /// null removes an edit.
  private read(text: string): Json {
    const s = text.trim().replace(",", ".");
    if (s === "") return null;
    return Number.isFinite(Number(s)) ? Number(s) : text.trim();
  }
}
