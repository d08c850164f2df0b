// The fields of one tool: its kind and its sizes, with a picture.
import { shape_of, with_inserts } from "../model/tool_shape";
import type { Insert, Tool } from "../protocol/types";
import { t, type TextKey } from "../texts/texts";
import { h, option } from "./dom";
import { tool_picture } from "./outline";

const kinds = ["flat", "ball", "bull", "drill", "taper", "chamfer", "tslot", "form", "turning"];
const sizes: (keyof Tool & ("diameter" | "corner" | "angle" | "lead" | "width" | "tip" | "flute_length" | "length"))[] =
  ["diameter", "corner", "angle", "lead", "width", "tip", "flute_length", "length"];
const sizes_of: Record<string, string[]> = {
  flat: [],
  ball: [],
  bull: ["corner"],
  drill: ["angle", "tip"],
  chamfer: ["angle", "tip"],
  taper: ["angle"],
  turning: ["corner", "angle", "lead", "width"],
};
/// The programmed point of an insert, by the directions from the nose's centre, with the number of the imaginary tip.
const tips: [string, string][] = [
  ["-x-z", "3"],
  ["-x+z", "4"],
  ["+x-z", "2"],
  ["+x+z", "1"],
  ["-x", "8"],
  ["+x", "6"],
  ["-z", "7"],
  ["+z", "5"],
  ["centre", "0, 9"],
];

/// A field whose text counts when it is left.
export function text_input(
  v: string,
  changed: (v: string) => void,
  more: Record<string, unknown> = {},
): HTMLInputElement {
  const e = h("input", { type: "text", value: v, ...more, onchange: () => changed(e.value) });
  return e;
}

/// `changed_shape`: the outlines of `inserts` no longer belong to the tool.
export function tool_form(x: Tool, inserts: Insert[], changed_shape: () => void): HTMLElement {
  const more = sizes_of[x.kind] ?? ["corner", "angle", "tip"],
    turns = x.kind === "turning";
  const changed = (): void => {
    delete x.by_offset; // it is no longer what the offset table says
    changed_shape();
  };
  const point = h(
    "select",
    {
      "aria-label": t("tip_number"),
      title: t("tip_number"),
      onchange: () => {
        x.points = point.value;
        changed();
      },
    },
    ...tips.map(([points, number]) => option(points, `${points} (${number})`, points === x.points)),
  );
  const select = h(
    "select",
    {
      "aria-label": t("kind"),
      onchange: () => {
        x.kind = select.value;
        if (x.kind === "turning") x.points ??= "-x-z";
        changed();
      },
    },
    ...kinds.map((k) => option(k, t(`kind_${k}` as TextKey), k === x.kind)),
  );
  const fields = sizes
    .filter((s) => [turns ? "" : "diameter", "flute_length", "length", ...more].includes(s))
    .map((s) =>
      h(
        "label",
        { class: "field small" },
        h("span", null, t(turns && s === "corner" ? "nose_radius" : s)),
        text_input(
          x[s] === undefined ? "" : String(x[s]),
          (v) => {
            if (v.trim() === "") delete x[s];
            else x[s] = Number(v.replace(",", "."));
            changed();
          },
          { inputmode: "decimal" },
        ),
      ),
    );
  return h(
    "fieldset",
    { class: x.known === false ? "tool-form unknown" : "tool-form" },
    h("legend", null, `T${x.number} ${x.name ?? ""}`),
    tool_picture(with_inserts(shape_of(x), inserts), `T${x.number}`, 44, 96),
    h(
      "div",
      { class: "tool-fields" },
      x.known === false && h("p", { class: "hint" }, t("shape_unknown")),
      h("div", { class: "row" }, select, turns && point, h("span", { class: "dim from" }, x.from ?? "")),
      h("div", { class: "fields" }, ...fields),
    ),
  );
}

/// The choice of a tools file, from which `take` reads the tools.
export function files_form(files: string[], take: (file: string) => void): HTMLElement {
  const select = h(
    "select",
    { onchange: () => select.value && take(select.value) },
    option("", "…", true),
    ...files.map((f) => option(f, f, false)),
  );
  return h("label", { class: "field" }, h("span", null, t("tools_from_file")), select);
}
