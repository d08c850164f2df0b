// What the server made of a drawing: said in sentences, as a picture, in figures.
import { field_title } from "./mill_fields";
import type { Field } from "../model/mill_form";
import type { Milled, NotMilled } from "../protocol/types";
import { t } from "../texts/texts";
import { fill, h } from "./dom";

export class MillAnswer {
  readonly told = h("div", { class: "mill-told", role: "status", "aria-live": "polite" });
  readonly picture = h("img", { class: "mill-picture", alt: t("mill_picture"), hidden: true });
  readonly summary = h("dl", { class: "facts mill-summary" });

  /// Nothing is asked for: fields are wrong, or still missing.
  show_incomplete(wrong: readonly Field[], missing: readonly Field[]): void {
    this.show_result(null);
    const list = (fields: readonly Field[]): string => fields.map(field_title).join(", ");
    fill(
      this.told,
      wrong.length
        ? h("p", { class: "hint error" }, t("mill_no_numbers", { fields: list(wrong) }))
        : h("p", { class: "note" }, t("mill_missing", { fields: list(missing) })),
    );
  }
  /// The last picture stays until the next one is there.
  show_busy(): void {
    fill(this.told, h("p", { class: "note" }, t("mill_working")));
  }
  show_refusal(why: string): void {
    this.show_result(null);
    fill(this.told, h("p", { class: "hint error" }, why));
  }

  /// null: nothing has been answered yet.
  show(a: Milled | null): void {
    this.show_result(a);
    fill(
      this.told,
      a?.warning && h("p", { class: "mill-warning" }, a.warning),
      a && h("p", { class: "good" }, t("mill_verified")),
      a && !a.picture && h("p", { class: "note" }, t("mill_no_picture")),
    );
  }

  show_problem(a: NotMilled, drawing: string): void {
    this.show_result(null);
    const p = a.problem,
      of_field = a.word !== "";
    fill(
      this.told,
      h(
        "p",
        { class: "hint error" },
        of_field
          ? t("mill_out_of_range", { field: field_title(a.word as Field) })
          : `${drawing}${p.line ? `:${p.line}` : ""}: ${p.text}`,
      ),
      a.line_text && h("code", { class: "block-text" }, a.line_text),
      !of_field && p.hint && h("p", { class: "hint" }, p.hint),
    );
  }

  /// Frees the picture.
  close(): void {
    this.show_picture("");
  }

  private show_result(a: Milled | null): void {
    this.show_picture(a?.picture ?? "");
    fill(this.summary, ...(a?.summary ?? []).flatMap((line) => [h("dt", null, line.name), h("dd", null, line.value)]));
  }

  /// Shown as a picture, never as a part of the page: nothing in a drawing can act here.
  private show_picture(svg: string): void {
    if (this.picture.src) URL.revokeObjectURL(this.picture.src);
    this.picture.hidden = svg === "";
    if (svg) this.picture.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
    else this.picture.removeAttribute("src");
  }
}
