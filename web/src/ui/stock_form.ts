// The blank as a form: a box, a bar or a tube, or any text that kadr cut takes.
import { box_of, cylinder_of, proper, stock_of, stock_of_cylinder, type Cylinder } from "../model/stock";
import type { BlankSource } from "../protocol/types";
import { t, type TextKey } from "../texts/texts";
import { h } from "./dom";
import { text_input } from "./tool_form";

/// `changed`: the blank as text.
export function stock_form(stock: string, by: BlankSource | null, changed: (stock: string) => void): HTMLElement {
  const box = box_of(stock),
    cylinder = cylinder_of(stock);
  const text = h(
    "label",
    { class: "field" },
    h("span", null, t("stock_as_text")),
    text_input(stock, changed, { class: "wide" }),
  );
  const told = by
    ? h("p", { class: "note" }, t(by.line ? "stock_by_line" : "stock_by_setup", { ...by }))
    : !stock && h("p", { class: "note" }, t("stock_none"));
  if (cylinder) return h("div", null, told, cylinder_form(cylinder, changed), text);
  if (!box) return h("div", null, told, text);
  const cell = (corner: 0 | 1, i: number): HTMLElement =>
    h(
      "td",
      null,
      text_input(
        String(box[corner][i]),
        (v) => {
          box[corner][i] = Number(v.replace(",", "."));
          changed(stock_of(box));
        },
        { inputmode: "decimal", "aria-label": `${"XYZ"[i]} ${t(corner ? "to" : "from")}` },
      ),
    );
  return h(
    "div",
    null,
    told,
    h(
      "table",
      { class: "list stock-form" },
      h(
        "thead",
        null,
        h("tr", null, h("th", null), h("th", { scope: "col" }, t("from")), h("th", { scope: "col" }, t("to"))),
      ),
      h(
        "tbody",
        null,
        ...[0, 1, 2].map((i) => h("tr", null, h("th", { scope: "row" }, "XYZ"[i]!), cell(0, i), cell(1, i))),
      ),
    ),
    !proper(box) && h("p", { class: "hint error" }, t("stock_inside_out")),
    text,
  );
}

/// A bar or a tube about Z.
function cylinder_form(c: Cylinder, changed: (stock: string) => void): HTMLElement {
  const field = (key: keyof Cylinder, name: TextKey): HTMLElement =>
    h(
      "label",
      { class: "field small" },
      h("span", null, t(name)),
      text_input(
        String(c[key]),
        (v) => {
          const n = Number(v.replace(",", "."));
          changed(Number.isFinite(n) ? stock_of_cylinder({ ...c, [key]: n }) : stock_of_cylinder(c));
        },
        { inputmode: "decimal" },
      ),
    );
  return h(
    "div",
    { class: "bar-form" },
    field("diameter", "blank_diameter"),
    field("bore", "blank_bore"),
    field("from", "blank_from"),
    field("to", "blank_to"),
  );
}

/// `fixtures`: one a line, as `kadr cut --fixture` has them.
export function fixtures_form(fixtures: string[], changed: (fixtures: string[]) => void): HTMLElement {
  const text = h(
    "textarea",
    {
      rows: String(Math.max(1, fixtures.length)),
      placeholder: "box:X0,Y0,Z0,X1,Y1,Z1",
      onchange: () =>
        changed(
          text.value
            .split("\n")
            .map((line) => line.trim())
            .filter((line) => line !== ""),
        ),
    },
    fixtures.join("\n"),
  );
  return h("label", { class: "field" }, h("span", null, t("fixtures")), text);
}
