// Positions, block and state of the machine in large figures: what an operator reads from two steps away.
import type { Operator } from "../model/operator";
import { axis_name, is_diameter, no_diameters } from "../model/diameters";
import { axis_unit, feed_unit, surface_unit, turn_unit } from "../model/units";
import type { Panel } from "../protocol/types";
import { t } from "../texts/texts";
import { fill, h } from "../ui/dom";
import { axis_value, feed, length, short, surface_figure } from "../ui/figures";
import { mark, write } from "../ui/update";

interface Row {
  axis: string;
  cells: [HTMLElement, HTMLElement, HTMLElement];
}

export class Readout {
  readonly element = h("section", { class: "readout" });
  private table = h("table", { class: "readout-positions" });
  private figures = h("dl", { class: "readout-figures" });
  private rows: Row[] = [];
  private values = new Map<string, HTMLElement>();
  private shape = ""; // of the table: axes, diameters, language

  constructor(private operator: Operator) {
    this.element.append(this.table, this.figures);
  }

  /// Draws the table again with the next state: the language or the unit has changed.
  renew(): void {
    this.shape = "";
  }

  show(p: Panel): void {
    const of = p.diameters ?? no_diameters,
      told = this.figures_of(p);
    const shape = JSON.stringify([this.operator.axes, of, told.map(([name]) => name)]);
    if (shape !== this.shape) {
      this.shape = shape;
      this.draw(of, told);
    }
    for (const { axis, cells } of this.rows)
      for (const [i, from] of [p.position, p.machine, p.togo].entries())
        write(cells[i]!, axis_value(axis, from[axis], of).replace("-", "\u2212"));
    for (const [name, value] of told) write(this.values.get(name)!, value);
    const limited = this.values.get("%");
    if (limited) limited.title = p.limit;
    mark(this.element, "moves", p.mode === "running");
  }

  private draw(of: readonly string[], told: [string, string, string][]): void {
    this.rows = this.operator.axes.map((axis) => ({
      axis,
      cells: [h("td", { class: "work" }), h("td"), h("td")],
    }));
    this.element.setAttribute("aria-label", t("op_readout"));
    fill(
      this.table,
      h(
        "thead",
        null,
        h(
          "tr",
          null,
          h("th", { scope: "col" }, h("span", { class: "unit" }, this.units())),
          ...(["work", "machine_position", "to_go"] as const).map((name) => h("th", { scope: "col" }, t(name))),
        ),
      ),
      h(
        "tbody",
        null,
        ...this.rows.map(({ axis, cells }) =>
          h(
            "tr",
            null,
            h("th", { scope: "row", title: is_diameter(axis, of) ? t("is_diameter") : "" }, axis_name(axis, of)),
            ...cells,
          ),
        ),
      ),
    );
    this.values = new Map(told.map(([name]) => [name, h("dd")]));
    fill(
      this.figures,
      ...told.map(([name, , long]) => h("div", { title: long }, h("dt", null, name), this.values.get(name)!)),
    );
  }

  private units(): string {
    return [...new Set(this.operator.axes.map(axis_unit))].join(" ");
  }

  /// Name, value and long name of each figure.
  private figures_of(p: Panel): [string, string, string][] {
    const now = p.rpm === null ? "–" : `${short(p.rpm)} ${t("rev_min")}`;
    return [
      ["F", `${feed(p.feed, 1)} ${feed_unit()}`, t("op_feed")],
      ...(typeof p.feed_per_turn === "number"
        ? ([["f", `${length(p.feed_per_turn)} ${turn_unit()}`, t("op_feed")]] as [string, string, string][])
        : []),
      ["V", `${feed(p.speed)} ${feed_unit()}`, t("op_speed")],
      ["%", `${Math.floor(100 * p.share * 1 + 1e-6)} %`, t("op_reached")],
      ["S", now, t("op_spindle")],
      ["M", turning(p), t("op_turning")],
      ...(p.surface
        ? ([["V c", `${surface_figure(p.surface.speed)} ${surface_unit()}`, t("op_surface")]] as [
            string,
            string,
            string,
          ][])
        : []),
      ["T", String(p.tool ?? "–"), t("op_tool")],
      ...(p.tool_offset
        ? ([] as [string, string, string][])
        : ([
            ["H", String(p.offsets.H ?? "–"), t("op_length")],
            ["D", String(p.offsets.D ?? "–"), t("op_radius")],
          ] as [string, string, string][])),
      ["G5x", p.modal.find((m) => /^G5[4-9](\.\d)?$/.test(m.code))?.code ?? "–", t("op_zero_in_force")],
    ];
  }
}

/// The code in force that turns the spindle or stops it.
const turning = (p: Panel): string => {
  const code = p.modal.find((m) => /^M0?[345]$/.test(m.code))?.code.replace("M0", "M");
  return code ?? "–";
};
