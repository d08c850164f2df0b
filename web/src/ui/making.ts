// A new program from a drawing: a form on the left, the result on the right, computed again after each change.
import type { App } from "../model/app";
import { debounce } from "../model/latest";
import { Making } from "../model/making";
import { remember, remembered } from "../model/memory";
import {
  directions,
  is_asked,
  lengths,
  marks,
  needed,
  plunges,
  question_of,
  schemes,
  tasks,
  type Field,
  type Figure,
  type MillForm,
} from "../model/mill_form";
import { files_beneath, save_new } from "../model/new_file";
import type { Socket } from "../protocol/client";
import type { Milled, NotMilled } from "../protocol/types";
import { t, type TextKey } from "../texts/texts";
import { open_dialog } from "./dialog";
import { button, fill, h, option } from "./dom";
import { may_leave, may_replace } from "./save";
import { toast } from "./toast";

const is_drawing = (name: string): boolean => /\.(dxf|svg|txt)$/i.test(name);
const pause = 350; // ms after the last key before it is computed again
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

export class MakingDialog {
  private making: Making;
  private dialog: HTMLDialogElement;
  private form: MillForm;
  private fields = h("form", {
    class: "mill-form",
    novalidate: true,
    onsubmit: (e: Event) => {
      e.preventDefault();
      this.preview();
    },
  });
  private told = h("div", { class: "mill-told", role: "status", "aria-live": "polite" });
  private picture = h("img", { class: "mill-picture", alt: t("mill_picture"), hidden: true });
  private summary = h("dl", { class: "facts mill-summary" });
  private name = h("input", {
    "aria-label": t("file_name"),
    size: "24",
    oninput: () => {
      this.name_typed = this.name.value !== "";
    },
    onkeydown: (e: KeyboardEvent) => {
      if (e.key === "Enter" && !this.save.disabled) void this.keep();
    },
  });
  private save = button(t("save_and_open"), () => void this.keep(), { class: "main", disabled: true });
  private fault = h("p", { class: "hint error", role: "alert" }); // of saving
  private name_typed = false;
  private drawings: string[] | null = null;
  private soon = debounce(pause, () => {
    if (this.dialog.open) this.ask_for_it();
  });

  /// `drawing`: the initial choice; `folder`: its drawings are listed first.
  constructor(
    private app: App,
    make: () => Socket,
    folder: string,
    drawing = "",
  ) {
    const control =
      app.opened?.control.id ?? remembered("making", {} as MillForm).control ?? app.hello?.controls[0]?.id ?? "";
    this.form = { task: "pocket", ...remembered("making", {} as MillForm), drawing, control };
    this.making = new Making(make);
    this.making.on_change.on(() => this.draw_answer());
    this.dialog = open_dialog(
      t("new_from_drawing"),
      h(
        "div",
        { class: "mill" },
        this.fields,
        h(
          "div",
          { class: "mill-result" },
          this.told,
          this.picture,
          this.summary,
          h(
            "div",
            { class: "row" },
            h("label", { class: "field" }, h("span", null, t("save_as")), this.name),
            this.save,
          ),
          this.fault,
        ),
      ),
      {
        wide: true,
        closed: () => {
          this.making.close();
          this.show_picture("");
        },
      },
    );
    this.draw();
    this.draw_answer();
    void this.list(folder);
  }

  private async list(folder: string): Promise<void> {
    try {
      this.drawings = await files_beneath(this.app, folder, is_drawing);
    } catch (e) {
      this.app.tell(e);
      this.drawings = [];
    }
    this.form.drawing ||= this.drawings.find((d) => d === remembered("making_drawing", "", "tab")) ?? "";
    this.draw();
    this.fields.querySelector<HTMLElement>("[name=drawing]")?.focus();
    this.ask_for_it();
  }

  private set(field: Field, value: string, draws: boolean): void {
    this.form[field] = value;
    if (field === "drawing") {
      this.name_typed = false;
      remember("making_drawing", value, "tab");
    }
    const { drawing: _, ...kept } = this.form;
    remember("making", kept);
    if (draws) this.draw();
    this.soon();
  }

  private preview(): void {
    this.ask_for_it(true);
  }

  private ask_for_it(again = false): void {
    const made = question_of(this.form);
    this.making.want("question" in made ? made.question : null, again);
    this.mark("wrong" in made ? made.wrong : []);
  }

  private draw(): void {
    const focused = (document.activeElement as HTMLInputElement | null)?.name;
    const { app, form } = this,
      chosen = (field: Field, values: readonly string[], shown: (v: string) => string): HTMLElement =>
        this.row(
          field,
          h(
            "select",
            {
              name: field,
              "aria-label": this.title(field),
              onchange: (e: Event) => this.set(field, (e.target as HTMLSelectElement).value, true),
            },
            ...values.map((v) => option(v, shown(v), v === (form[field] ?? ""))),
          ),
        );
    const drawings = this.drawings ?? [],
      known = form.drawing && !drawings.includes(form.drawing) ? [form.drawing, ...drawings] : drawings;
    fill(
      this.fields,
      this.group(
        "mill_what",
        chosen(
          "drawing",
          ["", ...known],
          (v) =>
            v || (this.drawings === null ? "…" : drawings.length ? t("mill_choose_drawing") : t("mill_no_drawings")),
        ),
        chosen("task", tasks, (v) => t(`mill_task_${v}` as TextKey)),
        chosen(
          "control",
          (app.hello?.controls ?? []).map((c) => c.id),
          (v) => app.hello?.controls.find((c) => c.id === v)?.name ?? v,
        ),
      ),
      this.group(
        "mill_sizes",
        this.figure("tool_diameter"),
        this.figure("depth"),
        this.figure("pass"),
        this.figure("width"),
        this.figure("allowance"),
        this.figure("top"),
        this.figure("clearance"),
        this.figure("overrun"),
      ),
      this.group(
        "mill_way",
        chosen("scheme", schemes, (v) =>
          v ? t(`mill_scheme_${v.replace("-", "_")}` as TextKey) : t("mill_usual_scheme"),
        ),
        chosen("direction", directions, (v) => t(v ? (`mill_${v}` as TextKey) : "mill_climb")),
        this.typed("stepover", form.task === "face" ? "70%" : "50%", t("mill_stepover_long")),
        this.figure("angle"),
        chosen("plunge", plunges, (v) => t(`mill_plunge_${v}` as TextKey)),
        this.figure("ramp_angle"),
        is_asked(form, "hole") && this.typed("hole", "X Y", t("mill_hole_long")),
      ),
      this.group(
        "mill_technology",
        this.figure("feed"),
        this.figure("plunge_feed"),
        this.figure("speed"),
        this.figure("tool"),
        h(
          "label",
          { class: "tick" },
          h("input", {
            type: "checkbox",
            name: "coolant",
            checked: form.coolant === "on",
            onchange: (e: Event) => this.set("coolant", (e.target as HTMLInputElement).checked ? "on" : "", false),
          }),
          t("mill_coolant"),
        ),
        chosen("mark", marks, (v) => v || t("mill_not_written")),
      ),
      h("div", { class: "row" }, h("button", { type: "submit" }, t("preview"))),
    );
    if (focused) this.fields.querySelector<HTMLElement>(`[name=${focused}]`)?.focus();
  }

  private group(title: TextKey, ...rows: (HTMLElement | false | null)[]): HTMLElement {
    return h("fieldset", null, h("legend", null, t(title)), ...rows);
  }
  private title(field: Field): string {
    return t(`mill_${field}` as TextKey);
  }
  private row(field: Field, input: HTMLElement, unit = ""): HTMLElement {
    return h(
      "label",
      { class: "mill-row", "data-field": field },
      h("span", null, this.title(field)),
      input,
      h("span", { class: "dim" }, unit),
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
        "aria-label": this.title(field),
        required: is_needed,
        autocomplete: "off",
        oninput: (e: Event) => this.set(field, (e.target as HTMLInputElement).value, false),
      }),
      unit,
    );
  }

  private figure(field: Figure): HTMLElement | false {
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

  /// Marks the wrong fields; all others are correct.
  private mark(wrong: readonly string[]): void {
    for (const row of this.fields.querySelectorAll<HTMLElement>("[data-field]")) {
      const input = row.querySelector("input, select")!;
      if (wrong.includes(row.dataset.field!)) input.setAttribute("aria-invalid", "true");
      else input.removeAttribute("aria-invalid");
    }
  }

  private draw_answer(): void {
    const { making } = this,
      a = making.answer,
      made = question_of(this.form);
    this.save.disabled = !making.program || !this.app.hello?.may_change;
    this.save.title = this.app.hello?.may_change ? "" : t("may_not_change");
    this.dialog.classList.toggle("making", making.busy);
    if (!("question" in made)) {
      this.show_result(null);
      const list = (fields: Field[]): string => fields.map((f) => this.title(f)).join(", ");
      return fill(
        this.told,
        h(
          "p",
          { class: made.wrong.length ? "hint error" : "note" },
          made.wrong.length
            ? t("mill_no_numbers", { fields: list(made.wrong) })
            : t("mill_missing", { fields: list(made.missing) }),
        ),
      );
    }
    if (making.busy) return fill(this.told, h("p", { class: "note" }, t("mill_working")));
    if (making.refusal) {
      this.show_result(null);
      return fill(this.told, h("p", { class: "hint error" }, making.refusal));
    }
    if (a && "problem" in a) return this.draw_problem(a);
    this.show_result(a);
    fill(
      this.told,
      a?.warning && h("p", { class: "mill-warning" }, a.warning),
      a && h("p", { class: "good" }, t("mill_verified")),
      a && !a.picture && h("p", { class: "note" }, t("mill_no_picture")),
    );
    if (a && !this.name_typed) this.name.value = a.name;
  }

  private draw_problem(a: NotMilled): void {
    this.show_result(null);
    this.mark([a.word]);
    const p = a.problem,
      of_field = a.word !== "";
    fill(
      this.told,
      h(
        "p",
        { class: "hint error" },
        of_field
          ? t("mill_out_of_range", { field: this.title(a.word as Field) })
          : `${this.form.drawing ?? ""}${p.line ? `:${p.line}` : ""}: ${p.text}`,
      ),
      a.line_text && h("code", { class: "block-text" }, a.line_text),
      !of_field && p.hint && h("p", { class: "hint" }, p.hint),
    );
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

  private async keep(): Promise<void> {
    const program = this.making.program,
      file = this.name.value.trim(),
      control = this.form.control;
    if (!program || !file) return this.name.focus();
    const fault = await save_new(this.app, file, { text: program.text }, () => may_replace(file));
    this.fault.textContent = fault;
    if (fault) return this.name.select();
    toast(t("saved", { file }));
    this.app.on_files.emit(file);
    if (!(await may_leave(this.app))) return;
    this.dialog.close();
    await this.app.open({ file, control });
  }
}
