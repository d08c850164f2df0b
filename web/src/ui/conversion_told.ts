// What a conversion has come to: its sentences, and the ways of writing that were rejected, with their lines.
import { by_reason } from "../model/convert_form";
import type { ConversionTry, Converted } from "../protocol/types";
import { t } from "../texts/texts";
import { button, h } from "./dom";

/// Shows a line of the open program (`file` 0), or of a file that it calls.
export type ShowLine = (line: number, file: number) => void;

/// `forced`: an unproven program was asked for too.
export function conversion_sentences(a: Converted, forced: boolean): HTMLElement[] {
  const w = a.written;
  if (w?.proven)
    return [
      h("p", { class: "good" }, a.text),
      h("p", null, t("convert_written", { way: w.way, by: a.tolerance.toFixed(5) })),
      ...(w.note ? [h("p", { class: "mill-warning" }, w.note)] : []),
    ];
  return [
    h("p", { class: "hint error" }, a.text),
    ...(w
      ? [h("p", { class: "mill-warning" }, t("convert_unproven", { way: w.way }))]
      : forced
        ? [h("p", { class: "note" }, t("convert_cannot"))]
        : []),
  ];
}

/// Rejected ways of writing: the reason, and its lines; null if there are none.
export function rejected_ways(a: Converted, show_line: ShowLine): HTMLElement | null {
  if (!a.tries.length) return null;
  const list = h(
    "ol",
    { class: "convert-tries" },
    ...by_reason(a.tries).map(({ ways, one }) =>
      h(
        "li",
        null,
        ...ways.map((way) => h("b", null, way)),
        h("p", null, one.text),
        place(one, show_line),
        one.written_line > 0 &&
          h(
            "p",
            { class: "dim" },
            t("convert_written_line", { line: one.written_line }),
            " ",
            h("code", null, one.written_text),
          ),
      ),
    ),
  );
  return a.written?.proven ? h("details", null, h("summary", null, t("convert_why_not")), list) : list;
}

function place(one: ConversionTry, show_line: ShowLine): HTMLElement | null {
  if (!one.line) return null;
  const told = one.file
    ? t("convert_called_line", { line: one.line, file: one.file_name || t("convert_called") })
    : t("line_n", { line: one.line });
  return h(
    "p",
    null,
    button(told, () => show_line(one.line, one.file), { class: "link" }),
    one.line_text && h("code", null, one.line_text),
  );
}
