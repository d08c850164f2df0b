// Parts of the state that need nothing but the state: feed and spindle, modal codes, zero, variables; offsets in words.
import { axis_name, is_diameter, no_diameters, type Diameters } from "../model/diameters";
import { axis_unit, feed_unit, length_unit, surface_unit, turn_unit } from "../model/units";
import type { Axes, State, ToolOffset } from "../protocol/types";
import { t } from "../texts/texts";
import { h } from "./dom";
import { axis_value, feed, length, short, surface_figure } from "./figures";

export function motion_of(s: State): HTMLElement {
  return h(
    "div",
    { class: "figures" },
    figure("F", feed(s.feed, 1), t("feed_programmed"), feed_unit()),
    figure("V", feed(s.speed), t("feed_reached"), feed_unit()),
    typeof s.feed_per_turn === "number" && figure("F", length(s.feed_per_turn), t("feed_per_turn"), turn_unit()),
    s.surface && figure("S", surface_figure(s.surface.speed), t("surface_speed"), surface_unit()),
    s.rpm !== null && figure(s.surface ? "n" : "S", short(s.rpm), t("spindle"), t("rev_min")),
    s.surface && figure("S max", s.surface.most === null ? "–" : short(s.surface.most), t("speed_limit"), t("rev_min")),
    s.limits ? h("div", { class: "limits" }, `${t("limited_by")} ${s.limits}`) : null,
  );
}

export function modal_of(s: State): HTMLElement {
  return h(
    "div",
    { class: "modal", role: "list", "aria-label": t("modal") },
    ...(s.modal ?? []).map((m) =>
      h(
        "span",
        {
          class: m.changed ? "code changed" : "code",
          role: "listitem",
          title: m.changed ? `${m.group} · ${t("changed_here")}` : m.group,
        },
        m.code,
      ),
    ),
  );
}

export function zero_of(s: State): HTMLElement | null {
  if (!Object.keys(s.zero ?? {}).length) return null;
  const of = s.diameters ?? no_diameters;
  return h(
    "div",
    { class: "row zero" },
    h("span", { class: "dim" }, t("zero")),
    ...Object.entries(s.zero ?? {}).map(([a, v]) =>
      h("span", null, h("b", null, axis_name(a, of)), ` ${axis_value(a, v, of)} ${axis_unit(a)}`),
    ),
  );
}

export function variables_of(s: State): HTMLElement | null {
  if (!s.variables?.length) return null;
  const sorted = [...s.variables].sort((a, b) => Number(b.changed ?? false) - Number(a.changed ?? false));
  return h(
    "div",
    { class: "variables" },
    h("h3", null, t("variables")),
    h(
      "div",
      { class: "variable-grid" },
      ...sorted
        .slice(0, 200)
        .map((v) =>
          h(
            "span",
            { class: v.changed ? "variable changed" : "variable", title: v.changed ? t("changed_here") : "" },
            h("b", null, v.name),
            ` ${value(v.value)}`,
          ),
        ),
    ),
  );
}

/// The row of a lathe's offset table: geometry and wear of each axis that has one, nose radius, number of the tip.
export function turning_offset(o: ToolOffset, of: Diameters): HTMLElement[] {
  const axes = Object.keys(o.geometry).filter((a) => a !== "Y" || o.geometry[a] || o.wear[a]);
  const title = (a: string, kind: string): string => (is_diameter(a, of) ? `${kind}, ${t("is_diameter")}` : kind);
  return [
    ...axes.flatMap((a) => [
      figure(
        axis_name(a, of),
        axis_value(a, o.geometry[a], of),
        title(a, t("geometry_of", { row: o.row })),
        length_unit(),
      ),
      figure(axis_name(a, of), axis_value(a, o.wear[a], of), title(a, t("wear_of", { row: o.row })), length_unit()),
    ]),
    figure("R", length(o.radius), t("nose_radius"), length_unit()),
    figure("T", String(o.tip), t("tip_number")),
  ];
}

/// The axes that have a length; a length along Z only, as on a mill, is written without its letter.
export function lengths_told(lengths: Axes | undefined): string {
  const all = Object.entries(lengths ?? {}),
    some = all.filter(([, v]) => Math.abs(v) >= 0.0005);
  if (!some.length) return all.length ? length(0) : "–";
  return some.length === 1 && some[0]![0] === "Z"
    ? length(some[0]![1])
    : some.map(([a, v]) => `${a}${axis_value(a, v)}`).join(" ");
}

const value = (v: number | string | null): string =>
  typeof v === "number" ? String(Number(v.toPrecision(9))) : (v ?? "–");

export function figure(name: string, v: string, title: string, its_unit = ""): HTMLElement {
  return h(
    "div",
    { class: "figure", title: its_unit ? `${title}, ${its_unit}` : title },
    h("span", { class: "figure-name" }, name),
    h("span", { class: "figure-value" }, v),
    h("span", { class: "figure-title" }, its_unit ? `${its_unit} · ${title}` : title),
  );
}
