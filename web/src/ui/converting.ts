// The open program for another control: requested, then proven and saved, or refused with the locations; the source
// stays visible next to it.
import type { App } from "../model/app";
import {
  beginning_of,
  by_reason,
  conversion_of,
  says_something,
  setup_name_of,
  type ConvertForm,
} from "../model/convert_form";
import { LongQuestion } from "../model/long_question";
import { remember, remembered } from "../model/memory";
import { save_new } from "../model/new_file";
import type { Socket } from "../protocol/client";
import type { ConversionTry, Converted, ConvertQuestion } from "../protocol/types";
import { t } from "../texts/texts";
import { open_dialog } from "./dialog";
import { button, fill, h, option } from "./dom";
import { clock } from "./figures";
import { may_leave, may_replace } from "./save";
import { toast } from "./toast";

const most_shown = 40_000; // characters of a text
type Written = NonNullable<Converted["written"]>;

export class ConvertDialog {
  private form: ConvertForm = {
    to: "",
    flat: false,
    ...remembered("convert", {} as Partial<ConvertForm>),
    force: false,
  };
  private asked: ConvertQuestion | null = null; // of the present or last conversion
  private asking: LongQuestion<"convert">;
  private dialog: HTMLDialogElement;
  private go = h("div", { class: "row" });
  private told = h("div", { class: "convert-told", role: "status", "aria-live": "polite" });
  private result = h("div", { class: "convert-result" });
  private fault = h("p", { class: "hint error", role: "alert" }); // of saving
  private name = h("input", { "aria-label": t("file_name"), size: "28", oninput: () => this.name_setup() });
  private setup = h("input", {
    "aria-label": t("convert_setup_name"),
    size: "28",
    oninput: () => {
      this.setup_typed = true;
    },
  });
  private setup_typed = false;
  private kept: { file: string; text: string }[] = []; // already saved from here
  private since = 0;
  private clock: ReturnType<typeof setInterval> | undefined;

  /// `line`: shows a line of the open program, or of a file that it calls.
  constructor(
    private app: App,
    make: () => Socket,
    private line: (line: number, file: number) => void,
  ) {
    const here = app.opened!.file;
    this.asking = new LongQuestion(make, "convert");
    this.asking.on_change.on(() => this.draw());
    const off = app.on_opening.on((file) => {
      if (file !== here) this.dialog.close();
    });
    const controls = h(
      "select",
      { name: "to", "aria-label": t("convert_to"), onchange: () => this.set("to", controls.value) },
      option("", t("convert_choose"), !this.form.to),
      ...(app.hello?.controls ?? []).map((c) =>
        option(
          c.id,
          c.id === app.opened!.control.id ? `${c.name} — ${t("convert_own")}` : c.name,
          c.id === this.form.to,
        ),
      ),
    );
    if (controls.value !== this.form.to) this.form.to = "";
    const tick = (field: "flat" | "force"): HTMLElement =>
      h(
        "label",
        { class: "tick" },
        h("input", {
          type: "checkbox",
          name: field,
          checked: this.form[field],
          onchange: (e: Event) => this.set(field, (e.target as HTMLInputElement).checked),
        }),
        t(`convert_${field}`),
      );
    this.dialog = open_dialog(
      `${t("convert_title")}: ${here}`,
      h(
        "div",
        { class: "convert" },
        h(
          "form",
          {
            novalidate: true,
            onsubmit: (e: Event) => {
              e.preventDefault();
              this.ask();
            },
          },
          h(
            "div",
            { class: "row" },
            h("label", { class: "field" }, h("span", null, t("convert_to")), controls),
            tick("flat"),
            tick("force"),
          ),
          this.go,
        ),
        this.told,
        this.result,
      ),
      {
        docked: "right",
        closed: () => {
          off();
          clearInterval(this.clock);
          this.asking.close();
        },
      },
    );
    this.draw();
    controls.focus();
  }

  private set<F extends keyof ConvertForm>(field: F, value: ConvertForm[F]): void {
    this.form[field] = value;
    remember("convert", { to: this.form.to, flat: this.form.flat });
    if (this.asked)
      this.asking.want((this.asked = null)); // the shown answer belongs to another request
    else this.draw();
  }

  private ask(): void {
    const question = conversion_of(this.app, this.form);
    if (!question || this.asking.busy) return;
    this.asked = question;
    this.kept = [];
    this.setup_typed = false;
    this.since = Date.now();
    this.asking.want(question, true);
  }

  private cancel(): void {
    this.asking.want((this.asked = null));
  }

  private draw(): void {
    const { asking } = this,
      answer = this.asked && !asking.busy ? asking.answer : null;
    clearInterval(this.clock);
    fill(
      this.go,
      asking.busy
        ? button(t("cancel"), () => this.cancel(), { class: "stop" })
        : h("button", { type: "submit", class: "main", disabled: !this.form.to }, t("convert_go")),
      asking.busy && h("span", { class: "note convert-clock" }),
    );
    if (asking.busy) {
      const tell = (): void => {
        this.go.querySelector(".convert-clock")!.textContent = clock((Date.now() - this.since) / 1000);
      };
      tell();
      this.clock = setInterval(tell, 1000);
    }
    this.fault.textContent = "";
    fill(
      this.told,
      ...(asking.busy
        ? [h("p", { class: "note" }, t("convert_working"))]
        : asking.refusal
          ? [h("p", { class: "hint error" }, asking.refusal)]
          : answer
            ? this.sentences(answer)
            : [h("p", { class: "note" }, t("convert_long"))]),
    );
    fill(this.result, ...(answer ? [answer.written ? this.written(answer.written) : null, this.tries(answer)] : []));
  }

  private sentences(a: Converted): HTMLElement[] {
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
        : this.asked?.force
          ? [h("p", { class: "note" }, t("convert_cannot"))]
          : []),
    ];
  }

  /// Rejected ways of writing: the reason, and its lines.
  private tries(a: Converted): HTMLElement | null {
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
          this.place(one),
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

  private place(one: ConversionTry): HTMLElement | null {
    if (!one.line) return null;
    const told = one.file
      ? t("convert_called_line", { line: one.line, file: one.file_name || t("convert_called") })
      : t("line_n", { line: one.line });
    return h(
      "p",
      null,
      button(told, () => this.line(one.line, one.file), { class: "link" }),
      one.line_text && h("code", null, one.line_text),
    );
  }

  private written(w: Written): HTMLElement {
    const program = beginning_of(w.program, most_shown),
      has_setup = says_something(w.setup),
      may = this.app.hello?.may_change === true;
    const can = { disabled: !may, title: may ? "" : t("may_not_change") };
    this.name.value = w.name;
    this.name_setup();
    return h(
      "div",
      { class: "convert-written" },
      h(
        "pre",
        { class: "block-text", tabindex: "0", "aria-label": t("source") },
        program.text,
        program.more > 0 && h("span", { class: "dim" }, t("convert_more", { count: program.more })),
      ),
      has_setup &&
        h(
          "details",
          null,
          h("summary", null, t("convert_setup")),
          h(
            "pre",
            { class: "block-text", tabindex: "0", "aria-label": t("convert_setup") },
            beginning_of(w.setup, most_shown).text,
          ),
        ),
      w.written_out.length > 0 &&
        h(
          "details",
          null,
          h("summary", null, t("convert_written_out", { count: w.written_out.length })),
          h(
            "ol",
            { class: "convert-tries" },
            ...w.written_out.map((o) =>
              h(
                "li",
                null,
                button(
                  o.to > o.from ? t("convert_lines", { from: o.from, to: o.to }) : t("line_n", { line: o.from }),
                  () => this.line(o.from, 0),
                  { class: "link" },
                ),
                o.text,
              ),
            ),
          ),
        ),
      h("label", { class: "mill-row" }, h("span", null, t("save_as")), this.name),
      has_setup && h("label", { class: "mill-row" }, h("span", null, t("convert_setup_name")), this.setup),
      this.fault,
      h(
        "div",
        { class: "row end" },
        button(t("save"), () => void this.keep(w), can),
        button(t("save_and_open"), () => void this.keep_and_open(w), { ...can, class: "main" }),
      ),
    );
  }

  private name_setup(): void {
    if (!this.setup_typed) this.setup.value = setup_name_of(this.name.value.trim());
  }

  /// Saves both, or reports why not. A file that was saved from here unchanged is not saved again.
  ///   returns  their names, the set-up undefined if none is needed; null if they are not saved
  private async keep(w: Written): Promise<{ file: string; setup?: string } | null> {
    const file = this.name.value.trim(),
      setup = says_something(w.setup) ? this.setup.value.trim() : undefined;
    if (!file) {
      this.name.focus();
      return null;
    }
    if (setup === "" || setup === file) {
      this.setup.focus();
      return null;
    }
    for (const one of [
      { file, text: w.program, input: this.name },
      ...(setup ? [{ file: setup, text: w.setup, input: this.setup }] : []),
    ]) {
      if (this.kept.some((k) => k.file === one.file && k.text === one.text)) continue;
      this.fault.textContent = await save_new(this.app, one.file, { text: one.text }, () => may_replace(one.file));
      if (this.fault.textContent) {
        one.input.select();
        return null;
      }
      this.kept.push({ file: one.file, text: one.text });
      this.app.on_files.emit(one.file);
    }
    toast(t("saved", { file: setup ? `${file}, ${setup}` : file }));
    return { file, setup };
  }

  private async keep_and_open(w: Written): Promise<void> {
    const control = this.asked!.to,
      machine = this.asked!.machine,
      kept = await this.keep(w);
    if (!kept || !(await may_leave(this.app))) return;
    this.dialog.close();
    await this.app.open({ file: kept.file, control, machine, setup: kept.setup });
  }
}
