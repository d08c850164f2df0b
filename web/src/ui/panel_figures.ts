// The figures of the panel: positions, speeds, tool, codes in force, several channels.
import { axis_name, is_diameter, no_diameters, type Diameters } from "../model/diameters";
import type { Operator } from "../model/operator";
import { axis_unit, feed_unit, surface_unit, turn_unit } from "../model/units";
import type { Panel, PanelChannel } from "../protocol/types";
import { t } from "../texts/texts";
import { fill, h } from "./dom";
import { axis_value, feed, length, short, surface_figure } from "./figures";
import { turning_offset } from "./state_parts";
import { set, write } from "./update";

/// The speed of the spindle: rev/min, and with constant surface speed also that speed and the limit of G50.
function spindle_told(p: Panel): [string, string][] {
  const now = p.rpm === null ? "–" : `${short(p.rpm)} ${t("rev_min")}`;
  if (!p.surface) return [["S", now]];
  return [
    ["S", `${surface_figure(p.surface.speed)} ${surface_unit()}`],
    ["n", now],
    ["S max", p.surface.most === null ? "–" : `${short(p.surface.most)} ${t("rev_min")}`],
  ];
}

/// What is drawn, and from what: its elements are drawn again only if that has changed.
class Drawn {
  private from = "";

  constructor(readonly element: HTMLElement) {}

  draw(from: unknown, children: () => (Node | string | false)[]): void {
    const told = JSON.stringify(from);
    if (told === this.from) return;
    this.from = told;
    fill(this.element, ...children());
  }
  forget(): void {
    this.from = "";
  }
}

export class PanelFigures {
  readonly element = h("div", { class: "operator-figures" });
  private codes = { number: -1, now: new Set<string>(), before: new Set<string>() }; // in force at the block, and at the one before
  private table = new Drawn(h("table", { class: "positions big" }));
  private row = new Drawn(h("div", { class: "row wrap" }));
  private turning = new Drawn(h("span", { class: "figures turning-offset" }));
  private modal = new Drawn(h("div", { class: "modal", role: "list" }));
  private channels = new Drawn(h("div", { class: "channels", role: "list" }));
  private cells: HTMLElement[] = []; // of the positions, row by row
  private values: HTMLElement[] = [];
  private share = h("span", { class: "dim share" });
  private limit = h("span", { class: "dim limit" });

  constructor(private operator: Operator) {
    const { table, row, channels, modal } = this;
    this.element.append(table.element, row.element, channels.element, modal.element);
    this.element.hidden = true;
  }

  /// No machine is on, or the words are others now.
  clear(): void {
    this.element.hidden = true;
    for (const d of [this.table, this.row, this.turning, this.modal, this.channels]) d.forget();
  }

  draw(p: Panel): void {
    this.element.hidden = false;
    this.draw_positions(p);
    this.draw_values(p);
    this.channels.element.hidden = p.channels.length < 2;
    if (p.channels.length > 1) this.channels.draw(p.channels, () => p.channels.map(channel));
    this.draw_codes(p);
  }

  private draw_positions(p: Panel): void {
    const of = p.diameters ?? no_diameters,
      { axes } = this.operator;
    this.table.draw([axes, of, axes.map(axis_unit)], () => this.positions(axes, of));
    const values = axes.flatMap((a) => [p.position[a], p.machine[a], p.togo[a]].map((v) => axis_value(a, v, of)));
    for (const [i, cell] of this.cells.entries()) write(cell, values[i] ?? "");
  }

  private positions(axes: string[], of: Diameters): HTMLElement[] {
    const rows = axes.map((a) => ({ a, cells: [h("td"), h("td"), h("td")] }));
    this.cells = rows.flatMap(({ cells }) => cells);
    const heads = (["work", "machine_position", "to_go"] as const).map((name) => h("th", { scope: "col" }, t(name)));
    return [
      h("thead", null, h("tr", null, h("th", null), ...heads, h("th", null))),
      h(
        "tbody",
        null,
        ...rows.map(({ a, cells }) =>
          h(
            "tr",
            null,
            h("th", { scope: "row", title: is_diameter(a, of) ? t("is_diameter") : "" }, axis_name(a, of)),
            ...cells,
            h("td", { class: "unit" }, axis_unit(a)),
          ),
        ),
      ),
    ];
  }

  private draw_values(p: Panel): void {
    const told = values_of(p);
    this.row.draw([told.map(([name]) => name), Boolean(p.tool_offset)], () => {
      this.values = told.map(() => h("span"));
      return [
        ...told.map(([name], i) => h("span", null, h("b", null, name), " ", this.values[i]!)),
        Boolean(p.tool_offset) && this.turning.element,
        this.share,
        this.limit,
      ];
    });
    for (const [i, [, value]] of told.entries()) write(this.values[i]!, value);
    const { tool_offset: offset } = p;
    if (offset) this.turning.draw(offset, () => turning_offset(offset, p.diameters ?? no_diameters));
    write(this.share, `${Math.floor(100 * p.share + 1e-6)} %`);
    write(this.limit, p.limit);
    set(this.limit, "title", t("limit_long"));
  }

  private draw_codes(p: Panel): void {
    if (p.number !== this.codes.number)
      this.codes = { number: p.number, now: new Set(p.modal.map((m) => m.code)), before: this.codes.now };
    const { before } = this.codes,
      is_new = (code: string): boolean => before.size > 0 && !before.has(code);
    const codes = p.modal.map((m) => ({ ...m, changed: is_new(m.code) }));
    set(this.modal.element, "aria-label", t("modal"));
    this.modal.draw(codes, () =>
      codes.map((m) =>
        h("span", { class: m.changed ? "code changed" : "code", role: "listitem", title: m.group }, m.code),
      ),
    );
  }
}

/// Name and value of each figure below the positions.
function values_of(p: Panel): [string, string][] {
  return [
    ["F", `${feed(p.feed, 1)} ${feed_unit()}`],
    ...(typeof p.feed_per_turn === "number"
      ? ([["F", `${length(p.feed_per_turn)} ${turn_unit()}`]] as [string, string][])
      : []),
    ["V", `${feed(p.speed)} ${feed_unit()}`],
    ...spindle_told(p),
    ["T", String(p.tool ?? "–")],
    ...(p.tool_offset
      ? []
      : ([
          ["D", String(p.offsets.D ?? "–")],
          ["H", String(p.offsets.H ?? "–")],
        ] as [string, string][])),
  ];
}

/// A channel next to the others, with which of them it waits for.
function channel(c: PanelChannel): HTMLElement {
  const does = c.waits
    ? t("waits_for", {
        code: c.waits.code,
        channels: c.waits.channels.filter((n) => !c.waits!.here.includes(n)).join(", ") || "–",
      })
    : t(c.moves ? "channel_moves" : "channel_stands");
  return h(
    "section",
    { class: c.waits ? "channel waits" : "channel", role: "listitem" },
    h(
      "div",
      { class: "row" },
      h("b", null, t("channel_n", { n: c.number })),
      h("span", { class: "grow" }, does),
      h("span", { class: "dim" }, c.line ? t("line_n", { line: c.line }) : ""),
    ),
    h("code", { class: "block-text" }, c.text),
    h(
      "div",
      { class: "row wrap" },
      ...c.axes.map((a) =>
        h("span", null, h("b", null, axis_name(a, c.diameters ?? [])), ` ${axis_value(a, c.position[a], c.diameters)}`),
      ),
    ),
  );
}
