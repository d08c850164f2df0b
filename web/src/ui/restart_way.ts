// The approach to the place of a restart: rules by which it is computed, and its points, which can be changed.
import { axis_name, factor } from "../model/diameters";
import type { Restart } from "../model/restart";
import { t } from "../texts/texts";
import { h } from "./dom";
import type { SheetPart } from "./restart_rows";

/// A field for a number. It shows the old number until the new one has been accepted.
function number_field(name: string, value: string, may: boolean, change: (v: number) => void): HTMLInputElement {
  const input = h("input", {
    size: "8",
    inputmode: "decimal",
    "aria-label": name,
    disabled: !may,
    value,
    onchange: () => {
      const v = Number(input.value.replace(",", "."));
      input.value = input.defaultValue;
      if (Number.isFinite(v)) change(v);
    },
  });
  return input;
}

export function way_rules(restart: Restart, may: boolean): HTMLElement {
  const rule = (name: "clearance" | "above" | "feed"): HTMLElement =>
    h(
      "label",
      { class: "field" },
      h("span", null, t(`restart_${name}`)),
      number_field(t(`restart_${name}`), String(restart.rules[name] ?? ""), may, (v) =>
        restart.set_rules({ [name]: v }),
      ),
    );
  return h(
    "section",
    null,
    h("h3", null, t("restart_way")),
    h("div", { class: "row wrap" }, rule("clearance"), rule("above"), rule("feed")),
  );
}

export function restart_way(restart: Restart, { sheet, of, may }: SheetPart): HTMLElement {
  const way = restart.way(sheet.number),
    own = sheet.number === restart.sheet!.number,
    name = own ? t("restart_way") : `${t("channel_n", { n: sheet.number })}: ${t("restart_way")}`;
  const coordinate = (i: number, axis: string, v: number): HTMLElement => {
    const shown = (factor(axis, of) * (v - (sheet.zero[axis] ?? 0))).toFixed(3);
    return h(
      "label",
      { class: "field" },
      h("span", null, axis_name(axis, of)),
      number_field(`${name} ${i + 1} ${axis}`, shown, may, (work) =>
        restart.set_point(i, axis, work / factor(axis, of), sheet.number),
      ),
    );
  };
  const points = way.map((p, i) =>
    h(
      "li",
      { class: "row" },
      h("b", null, p.rapid ? "G0" : "G1"),
      ...Object.entries(p.to).map(([axis, v]) => coordinate(i, axis, v)),
      !p.rapid && h("span", { class: "dim" }, `F${p.feed}`),
    ),
  );
  return h(
    "section",
    null,
    h("ol", { class: "restart-way" }, ...points),
    !way.length && h("p", { class: "note" }, t("restart_no_way")),
  );
}
