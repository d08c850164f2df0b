// The meaning of the path's colours: a ramp with its figures, or one line per kind of motion or tool.
import { is_rapid, spline } from "../protocol/frames";
import { colour_of_tool, is_ramp, ramp, type Range, type Rgba, type Theme } from "../scene/colours";
import type { ColourBy } from "../scene/types";
import { t, type TextKey } from "../texts/texts";
import { h } from "./dom";
import { feed_unit, in_unit, length_unit } from "../model/units";
import { clock, length, short } from "./figures";

export interface Coloured {
  by: ColourBy;
  range: Range | null;
  kinds: number[];
  tools: { tool: number; name?: string }[];
  theme: Theme;
}

const css = ([r, g, b, a]: Rgba): string => `rgba(${r}, ${g}, ${b}, ${Math.max(0.5, a / 255)})`;
const ticks = 5,
  most_tools = 12;

export function legend(c: Coloured): HTMLElement | null {
  if (is_ramp(c.by)) return ramp_legend(c.by, c.range);
  const rows =
    c.by === "kind"
      ? c.kinds.map((k) =>
          swatch(
            css(is_rapid(k) ? c.theme.rapid : c.theme.kinds[Math.min(k, c.theme.kinds.length - 1)]!),
            t(`motion_${Math.min(spline, k)}` as TextKey),
          ),
        )
      : c.tools.slice(0, most_tools).map((x) => swatch(css(colour_of_tool(x.tool)), `T${x.tool} ${x.name ?? ""}`));
  return rows.length
    ? h(
        "div",
        { class: "legend" },
        ...rows,
        c.by === "tool" &&
          c.tools.length > most_tools &&
          h("div", { class: "dim" }, `… +${c.tools.length - most_tools}`),
      )
    : null;
}

/// The figure at each tick of a ramp.
export function ramp_figures(by: ColourBy, [low, high]: Range): string[] {
  const shown = (v: number): number => (by === "feed" || by === "speed" ? in_unit(v) : v),
    wide = shown(high) - shown(low);
  const places = wide > 20 ? 0 : wide > 2 ? 1 : 3;
  const told = (v: number): string => (by === "time" ? clock(v) : by === "depth" ? length(v) : short(shown(v), places));
  if (!(high > low)) return low <= high ? [told(low)] : [];
  return Array.from({ length: ticks }, (_, i) => told(low + ((high - low) * i) / (ticks - 1)));
}

const units_of = (by: ColourBy): string =>
  by === "time" ? "" : by === "depth" ? length_unit() : by === "slowed" ? "%" : feed_unit();

function ramp_legend(by: ColourBy, range: Range | null): HTMLElement | null {
  const figures = range ? ramp_figures(by, range) : [];
  if (!figures.length) return null;
  const shades = Array.from({ length: 13 }, (_, i) => css(ramp(i, [0, 12])))
      .reverse()
      .join(", "),
    unit = units_of(by);
  const strip = h("div", { class: "legend-ramp" });
  strip.style.background = figures.length > 1 ? `linear-gradient(${shades})` : css(ramp(0, [0, 0]));
  return h(
    "div",
    { class: "legend" },
    h("div", { class: "dim" }, `${t(`colour_${by}`)}${unit ? `, ${unit}` : ""}`),
    h(
      "div",
      { class: "legend-scale" },
      strip,
      h("div", { class: "legend-figures" }, ...figures.reverse().map((f) => h("span", null, f))),
    ),
  );
}

function swatch(colour: string, name: string): HTMLElement {
  const sign = h("span", { class: "legend-swatch" });
  sign.style.background = colour;
  return h("div", { class: "legend-row" }, sign, h("span", null, name));
}
