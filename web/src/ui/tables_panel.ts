// Tables of a machine: values of the set-up file, edits made here, changes by the program. Edits are in force at once.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { JsonTable, Tables } from "../protocol/types";
import { on_language, t, type TextKey } from "../texts/texts";
import { button, fill, h, option, redraw } from "./dom";
import { axis_name, factor, no_diameters } from "../model/diameters";
import { read_value, table, table_rows, table_variables, type TableEdits } from "./table_rows";
import { toast } from "./toast";

export class TablesPanel {
  readonly element = h("details", { class: "tables" });
  private body = h("div");
  private tables: Tables | null = null;
  private section = "";
  private asking = false;
  private told = "{}"; // the edits, as last reported
  private edits: TableEdits = {
    take: (input, tables) => this.take(input, tables),
    edit: (tables) => void this.edit(tables),
  };

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
      this.section === "variables"
        ? table_variables(s, may, this.edits)
        : table_rows(s, this.section, this.operator, may, this.edits),
      this.section === "offsets" &&
        h(
          "div",
          { class: "row" },
          button(t("tables_propose"), () => void this.propose(s), { disabled: !may, title: t("tables_propose_long") }),
        ),
      this.section === "work_offsets" && this.touch_off(may),
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
        v = read_value(wanted.value);
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
}
