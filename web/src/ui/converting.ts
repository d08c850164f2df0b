// The open program for another control: requested, then proven and saved, or refused with the locations; the source
// stays visible next to it.
import type { App } from "../model/app";
import { conversion_of, type ConvertForm } from "../model/convert_form";
import { LongQuestion } from "../model/long_question";
import { remember, remembered } from "../model/memory";
import type { Socket } from "../protocol/client";
import type { ConvertQuestion } from "../protocol/types";
import { t } from "../texts/texts";
import { ConversionSaving, type Kept } from "./conversion_saving";
import { conversion_sentences, rejected_ways, type ShowLine } from "./conversion_told";
import { open_dialog } from "./dialog";
import { button, fill, h, option } from "./dom";
import { clock } from "./figures";
import { may_leave } from "./save";

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
  private saving: ConversionSaving;
  private since = 0;
  private clock: ReturnType<typeof setInterval> | undefined;

  /// `line`: shows a line of the open program, or of a file that it calls.
  constructor(
    private app: App,
    make: () => Socket,
    private line: ShowLine,
  ) {
    const here = app.opened!.file;
    this.saving = new ConversionSaving(app, line);
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
    this.saving.begin();
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
    this.saving.forget_fault();
    fill(
      this.told,
      ...(asking.busy
        ? [h("p", { class: "note" }, t("convert_working"))]
        : asking.refusal
          ? [h("p", { class: "hint error" }, asking.refusal)]
          : answer
            ? conversion_sentences(answer, this.asked?.force === true)
            : [h("p", { class: "note" }, t("convert_long"))]),
    );
    if (!answer) return fill(this.result);
    const asked = this.asked!,
      written = answer.written && this.saving.draw(answer.written, (kept) => this.open(kept, asked));
    fill(this.result, written, rejected_ways(answer, this.line));
  }

  private async open(kept: Kept, asked: ConvertQuestion): Promise<void> {
    if (!(await may_leave(this.app))) return;
    this.dialog.close();
    await this.app.open({ file: kept.file, control: asked.to, machine: asked.machine, setup: kept.setup });
  }
}
