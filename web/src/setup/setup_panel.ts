// The set-up of a program as a form: what the program uses, with the values of its set-up file and proposals of its
// comments. It is saved next to the program, which is run at once; no machine needs to be on.
import type { App } from "../model/app";
import { remember, remembered } from "../model/memory";
import { Refused } from "../protocol/client";
import type { SetupForm } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { ask } from "../ui/dialog";
import { button, fill, h } from "../ui/dom";
import { toast } from "../ui/toast";
import { FormValues } from "./form_values";
import { setup_table, setup_tools } from "./setup_tables";

const most_ranges = 10; // lines that were not executed

export class SetupPanel {
  readonly element = h("div", { class: "setup-form" });
  private values: FormValues | null = null;
  private of = ""; // the program of the form
  private stale = true;
  private asking = false;
  private head = h("div", { class: "setup-head" });
  private body = h("div");

  /// `line`: shows a line of the program; `cut`: shows blank and tools.
  constructor(
    private app: App,
    private line: (n: number) => void,
    private cut: () => void,
  ) {
    this.element.append(this.head, this.body);
    app.on_opening.on(() => this.outdated());
    app.on_done.on(() => this.outdated());
    on_language(() => this.outdated());
    new IntersectionObserver((seen) => {
      if (seen.some((s) => s.isIntersecting)) void this.load();
    }).observe(this.element);
    this.draw();
  }

  private outdated(): void {
    this.stale = true;
    if (this.element.isConnected) void this.load();
    else this.draw();
  }

  private async load(): Promise<void> {
    const file = this.app.opened?.file;
    if (!this.stale || this.asking || !file || !this.app.done) return this.draw();
    this.asking = true;
    try {
      const form = await this.app.client.ask("setup_form", {});
      this.take(file, form);
      this.stale = false;
    } catch (e) {
      this.app.tell(e);
    }
    this.asking = false;
    this.draw();
  }

  private take(file: string, form: SetupForm): void {
    if (this.values && this.of === file) return this.values.renew(form);
    this.of = file;
    this.values = new FormValues(form);
    this.values.take_kept(remembered<[string, string][]>(`setup_form.${file}`, [], "tab"));
  }

  private draw(): void {
    const { app, values } = this;
    const here = values && app.opened?.file === this.of;
    if (!here) {
      fill(this.head);
      fill(this.body, h("p", { class: "note" }, app.opened ? t("running") : t("open_a_program")));
      return;
    }
    this.draw_head(values);
    const verbs = {
      changed: () => this.changed(),
      drawn: () => {
        this.changed();
        this.draw();
      },
      line: this.line,
    };
    const { form } = values;
    const used = form.tables.filter((name) => values.rows(name).length > 0);
    const others = form.tables.filter((name) => !used.includes(name));
    fill(
      this.body,
      ...this.notes(form),
      ...used.map((name) => setup_table(name, values, verbs)),
      this.switches(values),
      setup_tools(form, this.line, this.cut),
      others.length > 0 &&
        h(
          "details",
          { class: "setup-others" },
          h("summary", null, t("setup_others")),
          ...others.map((name) => setup_table(name, values, verbs)),
        ),
    );
  }

  private draw_head(values: FormValues): void {
    const { form } = values,
      wrong = values.wrong().length,
      open = values.open();
    const may = Boolean(this.app.hello?.may_change);
    const state = wrong ? t("no_number") : open ? t("setup_open", { count: open }) : t("setup_complete");
    fill(
      this.head,
      h(
        "p",
        null,
        h("b", null, form.file),
        " ",
        h(
          "span",
          { class: "dim" },
          form.digest === null ? t("setup_new") : form.in_force ? t("setup_in_force") : t("setup_beside"),
        ),
      ),
      h("p", { class: wrong ? "hint error" : "note", "aria-live": "polite" }, state),
      h(
        "div",
        { class: "row wrap" },
        button(t("setup_save"), () => void this.save(), {
          class: "main setup-save",
          disabled: wrong > 0 || !may,
          title: may ? t("setup_save_long") : t("may_not_change"),
        }),
        values.touched &&
          button(t("setup_undo"), () => {
            values.forget();
            this.changed();
            this.draw();
          }),
      ),
    );
  }

  private notes(form: SetupForm): HTMLElement[] {
    const ranges = form.not_executed
      .slice(0, most_ranges)
      .map(([a, b]) => (a === b ? String(a) : `${a}–${b}`))
      .join(", ");
    const more = form.not_executed.length > most_ranges ? ", …" : "";
    const told = [
      form.rows.length === 0 && t("setup_nothing"),
      !this.app.opened?.machine && t("machine_none"),
      form.faults > 0 && t("setup_faults", { count: form.faults }),
      ranges && t("setup_not_executed", { lines: ranges + more }),
    ];
    return told.filter((text) => text).map((text) => h("p", { class: "note" }, text || ""));
  }

  private switches(values: FormValues): HTMLElement | false {
    const { rows } = values.form,
      skips = rows.filter((r) => r.table === "skip"),
      stop = rows.find((r) => r.table === "optional_stop");
    if (!skips.length && !stop) return false;
    const box = (text: string, line: number, on: boolean, set: (on: boolean) => void): HTMLElement => {
      const input = h("input", { type: "checkbox" });
      input.checked = on;
      input.addEventListener("change", () => {
        set(input.checked);
        this.changed();
      });
      return h(
        "div",
        { class: "row" },
        h("label", { class: "check" }, input, " ", text),
        button(t("used_in", { line }), () => this.line(line), { class: "link", title: t("show_line") }),
      );
    };
    return h(
      "section",
      { class: "setup-table", "data-table": "switches" },
      h("h3", null, t("setup_switches")),
      ...skips.map((r) =>
        box(t("setup_skip", { word: r.word }), r.line, values.skip(Number(r.row)), (on) =>
          values.set_skip(Number(r.row), on),
        ),
      ),
      stop &&
        box(t("setup_optional_stop"), stop.line, values.optional_stop, (on) => {
          values.optional_stop = on;
        }),
    );
  }

  private changed(): void {
    if (!this.values) return;
    remember(`setup_form.${this.of}`, this.values.kept(), "tab");
    this.draw_head(this.values);
  }

  /// Saves the set-up and runs the program with it. If somebody else has changed the file, nothing is overwritten.
  private async save(name?: string): Promise<void> {
    const { values, app } = this;
    if (!values || values.wrong().length) return;
    const file = name ?? values.form.file;
    const question = { file, digest: name ? null : values.form.digest, values: values.patch() };
    if (name) question.values = { ...values.form.stated, ...question.values }; // a copy has the whole
    try {
      await app.client.ask("keep_setup", question);
    } catch (e) {
      if (e instanceof Refused && e.changed) return this.conflict(file);
      return app.tell(e);
    }
    values.forget();
    remember(`setup_form.${this.of}`, [], "tab");
    toast(t("saved", { file }));
    app.on_files.emit(file);
    await app.run_again({ ...app.choice, setup: file });
  }

  private async conflict(file: string): Promise<void> {
    const choice = await ask(t("conflict"), t("setup_conflict", { file }), [
      ["renew", t("setup_renew")],
      ["copy", t("conflict_copy")],
      ["cancel", t("cancel")],
    ]);
    if (choice === "renew") {
      this.stale = true;
      await this.load();
    } else if (choice === "copy") await this.save(file.replace(/(\.[^./]*)?$/, (end) => `_2${end}`));
  }
}
