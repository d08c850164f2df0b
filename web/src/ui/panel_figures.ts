// The figures of the panel: positions, speeds, tool, codes in force, several channels.
import { axis_name, is_diameter, no_diameters } from "../model/diameters";
import type { Operator } from "../model/operator";
import { axis_unit, feed_unit, surface_unit, turn_unit } from "../model/units";
import type { Panel, PanelChannel } from "../protocol/types";
import { t } from "../texts/texts";
import { fill, h } from "./dom";
import { axis_value, feed, length, short, surface_figure } from "./figures";
import { turning_offset } from "./state_parts";

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

export class PanelFigures {
  readonly element = h("div", { class: "operator-figures" });
  private codes = { number: -1, now: new Set<string>(), before: new Set<string>() }; // in force at the block, and at the one before

  constructor(private operator: Operator) {}

  draw(p: Panel): void {
    if (p.number !== this.codes.number)
      this.codes = { number: p.number, now: new Set(p.modal.map((m) => m.code)), before: this.codes.now };
    const is_new = (code: string): boolean => this.codes.before.size > 0 && !this.codes.before.has(code);
    const of = p.diameters ?? no_diameters;
    const cell = (a: string, v: number | null | undefined): HTMLElement => h("td", null, axis_value(a, v, of));
    fill(
      this.element,
      h(
        "table",
        { class: "positions big" },
        h(
          "thead",
          null,
          h(
            "tr",
            null,
            h("th", null),
            h("th", { scope: "col" }, t("work")),
            h("th", { scope: "col" }, t("machine_position")),
            h("th", { scope: "col" }, t("to_go")),
            h("th", null),
          ),
        ),
        h(
          "tbody",
          null,
          ...this.operator.axes.map((a) =>
            h(
              "tr",
              null,
              h("th", { scope: "row", title: is_diameter(a, of) ? t("is_diameter") : "" }, axis_name(a, of)),
              cell(a, p.position[a]),
              cell(a, p.machine[a]),
              cell(a, p.togo[a]),
              h("td", { class: "unit" }, axis_unit(a)),
            ),
          ),
        ),
      ),
      h(
        "div",
        { class: "row wrap" },
        ...(
          [
            ["F", `${feed(p.feed, 1)} ${feed_unit()}`],
            ...(typeof p.feed_per_turn === "number"
              ? ([["F", `${length(p.feed_per_turn)} ${turn_unit()}`]] as const)
              : []),
            ["V", `${feed(p.speed)} ${feed_unit()}`],
            ...spindle_told(p),
            ["T", p.tool ?? "–"],
            ...(p.tool_offset
              ? ([] as const)
              : ([
                  ["D", p.offsets.D ?? "–"],
                  ["H", p.offsets.H ?? "–"],
                ] as const)),
          ] as const
        ).map(([name, v]) => h("span", null, h("b", null, name), ` ${v}`)),
        p.tool_offset && h("span", { class: "figures turning-offset" }, ...turning_offset(p.tool_offset, of)),
        h("span", { class: "dim share" }, `${Math.floor(100 * p.share + 1e-6)} %`),
        h("span", { class: "dim limit", title: t("limit_long") }, p.limit),
      ),
      p.channels.length > 1 && beside(p.channels),
      h(
        "div",
        { class: "modal", role: "list", "aria-label": t("modal") },
        ...p.modal.map((m) =>
          h("span", { class: is_new(m.code) ? "code changed" : "code", role: "listitem", title: m.group }, m.code),
        ),
      ),
    );
  }
}

/// Side by side, with which channel waits for which.
function beside(all: PanelChannel[]): HTMLElement {
  const does = (c: PanelChannel): string =>
    c.waits
      ? t("waits_for", {
          code: c.waits.code,
          channels: c.waits.channels.filter((n) => !c.waits!.here.includes(n)).join(", ") || "–",
        })
      : c.moves
        ? t("channel_moves")
        : t("channel_stands");
  return h(
    "div",
    { class: "channels", role: "list" },
    ...all.map((c) =>
      h(
        "section",
        { class: c.waits ? "channel waits" : "channel", role: "listitem" },
        h(
          "div",
          { class: "row" },
          h("b", null, t("channel_n", { n: c.number })),
          h("span", { class: "grow" }, does(c)),
          h("span", { class: "dim" }, c.line ? t("line_n", { line: c.line }) : ""),
        ),
        h("code", { class: "block-text" }, c.text),
        h(
          "div",
          { class: "row wrap" },
          ...c.axes.map((a) =>
            h(
              "span",
              null,
              h("b", null, axis_name(a, c.diameters ?? [])),
              ` ${axis_value(a, c.position[a], c.diameters)}`,
            ),
          ),
        ),
      ),
    ),
  );
}
