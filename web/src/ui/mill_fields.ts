// The fields of the form that makes a program from a drawing: what is milled, sizes, the way of milling, technology.
import type { App } from "../model/app";
import {
  directions,
  is_asked,
  lengths,
  marks,
  needed,
  plunges,
  schemes,
  tasks,
  type Field,
  type Figure,
  type MillForm,
} from "../model/mill_form";
import { t, type TextKey } from "../texts/texts";
import { fill, h, option } from "./dom";

const usual: Partial<Record<Field, TextKey>> = {
  pass: "mill_all_at_once",
  width: "mill_as_tool",
  plunge_feed: "mill_a_third",
  speed: "mill_not_written",
  tool: "mill_not_written",
};
const defaults: Partial<Record<Field, string>> = {
  allowance: "0",
  top: "0",
  clearance: "5",
  overrun: "2",
  angle: "0",
  ramp_angle: "3",
  feed: "300",
};

export const field_title = (field: Field): string => t(`mill_${field}` as TextKey);

type Row = HTMLElement | false;
export interface FieldVerbs {
  /// `draws`: other fields are asked for now.
  set(field: Field, value: string, draws: boolean): void;
  preview(): void;
}

export class MillFields {
  readonly element = h("form", {
    class: "mill-form",
    novalidate: true,
    onsubmit: (e: Event) => {
      e.preventDefault();
      this.verbs.preview();
    },
  });

  constructor(
    private app: App,
    private form: MillForm,
    private verbs: FieldVerbs,
  ) {}

  focus(field: string): void {
    this.element.querySelector<HTMLElement>(`[name=${field}]`)?.focus();
  }

  /// `drawings`: names of the drawings to choose from; null: they are not known yet.
  draw(drawings: readonly string[] | null): void {
    const focused = (document.activeElement as HTMLInputElement | null)?.name;
    fill(
      this.element,
      this.group("mill_what", ...this.what(drawings)),
      this.group("mill_sizes", ...this.sizes()),
      this.group("mill_way", ...this.way()),
      this.group("mill_technology", ...this.technology()),
      h("div", { class: "row" }, h("button", { type: "submit" }, t("preview"))),
    );
    if (focused) this.focus(focused);
  }

  /// Marks the wrong fields; all others are correct.
  mark(wrong: readonly string[]): void {
    for (const row of this.element.querySelectorAll<HTMLElement>("[data-field]")) {
      const input = row.querySelector("input, select")!;
      if (wrong.includes(row.dataset.field!)) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
    }
  }

  private what(drawings: readonly string[] | null): HTMLElement[] {
    const { form, app } = this,
      found = drawings ?? [],
      known = form.drawing && !found.includes(form.drawing) ? [form.drawing, ...found] : found,
      none = drawings === null ? "…" : t(found.length ? "mill_choose_drawing" : "mill_no_drawings"),
      controls = app.hello?.controls ?? [];
    return [
      this.chosen("drawing", ["", ...known], (v) => v || none),
      this.chosen("task", tasks, (v) => t(`mill_task_${v}` as TextKey)),
      this.chosen(
        "control",
        controls.map((c) => c.id),
        (v) => controls.find((c) => c.id === v)?.name ?? v,
      ),
    ];
  }

  private sizes(): Row[] {
    return (["tool_diameter", "depth", "pass", "width", "allowance", "top", "clearance", "overrun"] as const).map(
      (field) => this.figure(field),
    );
  }

  private way(): Row[] {
    return [
      this.chosen("scheme", schemes, (v) =>
        v ? t(`mill_scheme_${v.replace("-", "_")}` as TextKey) : t("mill_usual_scheme"),
      ),
      this.chosen("direction", directions, (v) => t(v ? (`mill_${v}` as TextKey) : "mill_climb")),
      this.typed("stepover", this.form.task === "face" ? "70%" : "50%", t("mill_stepover_long")),
      this.figure("angle"),
      this.chosen("plunge", plunges, (v) => t(`mill_plunge_${v}` as TextKey)),
      this.figure("ramp_angle"),
      is_asked(this.form, "hole") && this.typed("hole", "X Y", t("mill_hole_long")),
    ];
  }

  private technology(): Row[] {
    return [
      ...(["feed", "plunge_feed", "speed", "tool"] as const).map((field) => this.figure(field)),
      h(
        "label",
        { class: "tick" },
        h("input", {
          type: "checkbox",
          name: "coolant",
          checked: this.form.coolant === "on",
          onchange: (e: Event) => this.verbs.set("coolant", (e.target as HTMLInputElement).checked ? "on" : "", false),
        }),
        t("mill_coolant"),
      ),
      this.chosen("mark", marks, (v) => v || t("mill_not_written")),
    ];
  }

  private group(title: TextKey, ...rows: Row[]): HTMLElement {
    return h("fieldset", null, h("legend", null, t(title)), ...rows);
  }
  private row(field: Field, input: HTMLElement, unit = ""): HTMLElement {
    return h(
      "label",
      { class: "mill-row", "data-field": field },
      h("span", null, field_title(field)),
      input,
      h("span", { class: "dim" }, unit),
    );
  }

  private chosen(field: Field, values: readonly string[], shown: (v: string) => string): HTMLElement {
    return this.row(
      field,
      h(
        "select",
        {
          name: field,
          "aria-label": field_title(field),
          onchange: (e: Event) => this.verbs.set(field, (e.target as HTMLSelectElement).value, true),
        },
        ...values.map((v) => option(v, shown(v), v === (this.form[field] ?? ""))),
      ),
    );
  }

  private typed(field: Field, placeholder: string, long = "", unit = ""): HTMLElement {
    const is_needed = (needed as readonly string[]).includes(field);
    return this.row(
      field,
      h("input", {
        name: field,
        value: this.form[field] ?? "",
        placeholder,
        title: long,
        "aria-label": field_title(field),
        required: is_needed,
        autocomplete: "off",
        oninput: (e: Event) => this.verbs.set(field, (e.target as HTMLInputElement).value, false),
      }),
      unit,
    );
  }

  private figure(field: Figure): Row {
    if (!is_asked(this.form, field)) return false;
    const unit = (lengths as readonly string[]).includes(field)
      ? t("mm")
      : field.endsWith("angle")
        ? "°"
        : field.endsWith("feed")
          ? t("mm_min")
          : field === "speed"
            ? t("rev_min")
            : "";
    const key = usual[field];
    return this.typed(field, key ? t(key) : (defaults[field] ?? ""), "", unit);
  }
}
