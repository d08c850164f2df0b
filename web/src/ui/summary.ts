// The program in figures: its extents, time, distances, tools.
import type { App } from "../model/app";
import type { Box } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { axis_name, no_diameters, type Diameters } from "../model/diameters";
import { in_unit, length_unit, unit } from "../model/units";
import { axis_value, clock, length, short } from "./figures";
import { icon } from "./icons";

export class SummaryPanel {
  readonly element = h("div", { class: "summary" });

  constructor(private app: App) {
    for (const s of [app.on_done, app.on_opened, app.on_opening]) s.on(() => this.draw());
    on_language(() => this.draw());
    this.draw();
  }

  private draw(): void {
    const d = this.app.done,
      o = this.app.opened;
    if (!d) return fill(this.element, h("p", { class: "note" }, o ? t("running") : t("open_a_program")));
    fill(
      this.element,
      d.unstated && h("p", { class: "hint" }, d.unstated),
      h(
        "dl",
        { class: "facts" },
        ...fact(t("time"), clock(d.seconds)),
        ...fact(t("time_cutting"), clock(d.times.cutting)),
        ...fact(t("time_rapid"), clock(d.times.rapid)),
        ...fact(t("time_dwell"), clock(d.times.dwell)),
        ...fact(t("time_tools"), clock(d.times.tools)),
        ...fact(t("way_cutting"), metres(d.distances.cutting)),
        ...fact(t("way_rapid"), metres(d.distances.rapid)),
        ...fact(t("blocks"), short(d.blocks)),
        ...fact(t("lines"), short(o?.lines)),
        ...fact(t("units"), t(d.units === "inch" ? "units_inch" : "units_mm")),
      ),
      h("h3", null, t("extents")),
      extents(d.extents, d.axes, d.diameters),
      this.tools(),
    );
  }

  private tools(): HTMLElement {
    const tools = this.app.done!.tools;
    if (!tools.length) return h("p", { class: "note" }, t("tools_not_called"));
    return h(
      "table",
      { class: "list" },
      h(
        "thead",
        null,
        h(
          "tr",
          null,
          ...[t("tool"), t("name"), `R, ${length_unit()}`, `L, ${length_unit()}`, t("time"), ""].map((x) =>
            h("th", { scope: "col" }, x),
          ),
        ),
      ),
      h(
        "tbody",
        null,
        ...tools.map((x) =>
          h(
            "tr",
            null,
            h("td", null, `T${x.tool}`),
            h("td", { class: "text" }, x.name ?? ""),
            h("td", null, length(x.radius)),
            h("td", null, length(x.length)),
            h("td", null, clock(x.seconds)),
            h(
              "td",
              null,
              button(icon("go"), () => this.app.seek(x.from), {
                class: "icon",
                title: t("go_to_start"),
                "aria-label": t("go_to_start"),
              }),
            ),
          ),
        ),
      ),
    );
  }
}

const metres = (mm: number): string =>
  unit() === "inch"
    ? `${in_unit(mm).toFixed(1)} ${t("inch")}`
    : mm >= 1000
      ? `${(mm / 1000).toFixed(2)} ${t("m")}`
      : `${mm.toFixed(1)} ${t("mm")}`;
export const fact = (name: string, v: string): HTMLElement[] => [h("dt", null, name), h("dd", null, v)];

/// Axes of `diameters` are shown as diameters.
export function extents(
  e: { cutting: Box | null; all: Box | null },
  axes: string[] = ["X", "Y", "Z"],
  diameters: Diameters = no_diameters,
): HTMLElement {
  const row = (name: string, b: Box | null, i: number): HTMLElement =>
    h(
      "tr",
      null,
      h("th", { scope: "row" }, axis_name(name, diameters)),
      h("td", null, axis_value(name, b?.[0][i], diameters)),
      h("td", null, axis_value(name, b?.[1][i], diameters)),
      h("td", null, b ? axis_value(name, b[1][i]! - b[0][i]!, diameters) : "–"),
    );
  // the box has X, Y, Z; a lathe has no Y
  const names = ["X", "Y", "Z"].map((n, i) => ({ n, i })).filter(({ n }) => axes.includes(n));
  const part = (title: string, b: Box | null): Node[] => [
    h("tr", null, h("th", { colspan: "4", scope: "rowgroup", class: "group" }, title)),
    ...names.map(({ n, i }) => row(n, b, i)),
  ];
  return h(
    "table",
    { class: "list" },
    h(
      "thead",
      null,
      h(
        "tr",
        null,
        h("th", null),
        h("th", { scope: "col" }, `${t("from")}, ${length_unit()}`),
        h("th", { scope: "col" }, `${t("to")}, ${length_unit()}`),
        h("th", { scope: "col" }, `${t("size")}, ${length_unit()}`),
      ),
    ),
    h("tbody", null, ...part(t("extents_cutting"), e.cutting), ...part(t("extents_all"), e.all)),
  );
}
