// The set-up sheet: tools with their shapes, work offsets, extents, stops and the programmer's notes, with the
// picture; printed by the browser.
import type { App } from "../model/app";
import type { Sheet, SheetTool } from "../protocol/types";
import type { Shape } from "../model/tool_shape";
import { t } from "../texts/texts";
import { open_dialog } from "./dialog";
import { button, h } from "./dom";
import { axis_name, no_diameters } from "../model/diameters";
import { axis_unit, length_unit } from "../model/units";
import { axis_value, clock, length } from "./figures";
import { tool_picture } from "./outline";
import { extents, fact } from "./summary";

export async function show_sheet(app: App, picture: () => Promise<Blob>, shapes: Shape[]): Promise<void> {
  let sheet: Sheet;
  try {
    if (!(await app.run_shown())) return;
    sheet = await app.client.ask("sheet", {});
  } catch (e) {
    return app.tell(e);
  }
  const image = await picture().then(
    (b) => URL.createObjectURL(b),
    () => "",
  ); // the sheet is useful without a picture too
  open_dialog(t("sheet"), sheet_element(sheet, image, shapes, app.done?.axes), {
    wide: true,
    tools: button(t("print"), () => window.print(), { class: "main" }),
    closed: () => {
      if (image) URL.revokeObjectURL(image);
    },
  });
}

/// `axes` of the program: a lathe has no Y.
export function sheet_element(s: Sheet, image: string, shapes: Shape[], axes?: string[]): HTMLElement {
  return h(
    "article",
    { class: "sheet" },
    h(
      "div",
      { class: "sheet-top" },
      h(
        "div",
        null,
        h("h1", null, s.program),
        h(
          "dl",
          { class: "facts" },
          ...fact(t("control"), s.control),
          ...fact(t("machine"), s.machine ?? "–"),
          ...fact(t("date"), s.date),
          ...fact(t("time"), clock(s.seconds)),
        ),
      ),
      image && h("img", { src: image, alt: t("picture"), class: "sheet-picture" }),
    ),
    h("h3", null, t("tools")),
    s.tools.length ? tool_table(s.tools, shapes) : h("p", { class: "note" }, t("tools_not_called")),
    h(
      "div",
      { class: "sheet-columns" },
      h("div", null, h("h3", null, t("zeros")), zeros(s)),
      h("div", null, h("h3", null, t("extents")), extents(s.extents, axes, s.diameters)),
    ),
    s.stops.length > 0 && h("h3", null, t("stops")),
    s.stops.length > 0 && notes(s.stops.map((x) => [x.line, `${clock(x.at)}  ${x.text}`])),
    s.comments.length > 0 && h("h3", null, t("notes")),
    s.comments.length > 0 && notes(s.comments.map((x) => [x.line, x.text])),
  );
}

function tool_table(tools: SheetTool[], shapes: Shape[]): HTMLElement {
  const head = [
    "",
    t("tool"),
    t("name"),
    `R, ${length_unit()}`,
    `L, ${length_unit()}`,
    t("corrector"),
    t("time"),
    t("lines"),
    t("comment"),
  ];
  return h(
    "table",
    { class: "list sheet-tools" },
    h(
      "thead",
      null,
      h("tr", null, ...head.map((x, i) => h("th", { scope: "col", class: [2, 5, 7, 8].includes(i) ? "text" : "" }, x))),
    ),
    h(
      "tbody",
      null,
      ...tools.map((x) => {
        const shape = shapes.find((y) => y.number === x.number) ?? {
          number: x.number,
          cutting: x.outline ?? [],
          shank: [],
          holder: [],
        };
        return h(
          "tr",
          null,
          h("td", null, tool_picture(shape, `T${x.number}`, 48, 72)),
          h("td", null, `T${x.number}`),
          h("td", { class: "text" }, x.name ?? ""),
          h("td", null, length(x.radius)),
          h("td", null, length(x.length)),
          h(
            "td",
            { class: "text" },
            String(x.corrector || "–"),
            ...(x.shared ?? []).map((s) =>
              h(
                "div",
                { class: "hint shared" },
                t("also_used", { word: s.word, tools: s.tools.map((n) => `T${n}`).join(", ") }),
              ),
            ),
          ),
          h("td", null, clock(x.seconds)),
          h("td", { class: "text" }, (x.lines ?? []).slice(0, 12).join(", ")),
          h("td", { class: "text" }, x.comment ?? ""),
        );
      }),
    ),
  );
}

function zeros(s: Sheet): HTMLElement {
  const of = s.diameters ?? no_diameters;
  if (!s.zeros.length) return h("p", { class: "note" }, t("zeros_none"));
  return h(
    "table",
    { class: "list" },
    h(
      "tbody",
      null,
      ...s.zeros.map((z) =>
        h(
          "tr",
          null,
          h("th", { scope: "row" }, z.name),
          h(
            "td",
            { class: "text" },
            Object.entries(z.values)
              .map(([a, v]) => `${axis_name(a, of)} ${axis_value(a, v, of)} ${axis_unit(a)}`)
              .join(", ") || t("zero_unstated"),
          ),
        ),
      ),
    ),
  );
}

const notes = (rows: [number, string][]): HTMLElement =>
  h(
    "table",
    { class: "list" },
    h(
      "tbody",
      null,
      ...rows.map(([line, text]) =>
        h("tr", null, h("td", { class: "note-line" }, String(line)), h("td", { class: "text" }, text)),
      ),
    ),
  );
