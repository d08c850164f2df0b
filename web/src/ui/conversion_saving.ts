// The program that a conversion has written: shown, and saved together with its set-up.
import type { App } from "../model/app";
import { beginning_of, says_something, setup_name_of } from "../model/convert_form";
import { save_new } from "../model/new_file";
import type { Converted } from "../protocol/types";
import { t } from "../texts/texts";
import type { ShowLine } from "./conversion_told";
import { button, h } from "./dom";
import { may_replace } from "./save";
import { toast } from "./toast";

export type Written = NonNullable<Converted["written"]>;
/// The names of what was saved; the set-up is undefined if none is needed.
export interface Kept {
  file: string;
  setup?: string;
}

const most_shown = 40_000; // characters of a text

export class ConversionSaving {
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

  constructor(
    private app: App,
    private show_line: ShowLine,
  ) {}

  /// Another conversion begins.
  begin(): void {
    this.kept = [];
    this.setup_typed = false;
  }
  forget_fault(): void {
    this.fault.textContent = "";
  }

  /// `open`: opens what was saved.
  draw(w: Written, open: (kept: Kept) => Promise<void>): HTMLElement {
    const has_setup = says_something(w.setup),
      may = this.app.hello?.may_change === true,
      can = { disabled: !may, title: may ? "" : t("may_not_change") };
    this.name.value = w.name;
    this.name_setup();
    return h(
      "div",
      { class: "convert-written" },
      text_of(w.program, t("source")),
      has_setup && h("details", null, h("summary", null, t("convert_setup")), text_of(w.setup, t("convert_setup"))),
      this.written_out(w),
      h("label", { class: "mill-row" }, h("span", null, t("save_as")), this.name),
      has_setup && h("label", { class: "mill-row" }, h("span", null, t("convert_setup_name")), this.setup),
      this.fault,
      h(
        "div",
        { class: "row end" },
        button(t("save"), () => void this.keep(w), can),
        button(t("save_and_open"), () => void this.keep_and_open(w, open), { ...can, class: "main" }),
      ),
    );
  }

  /// Lines that are written out as others, with the reason.
  private written_out(w: Written): HTMLElement | false {
    return (
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
                () => this.show_line(o.from, 0),
                { class: "link" },
              ),
              o.text,
            ),
          ),
        ),
      )
    );
  }

  private name_setup(): void {
    if (!this.setup_typed) this.setup.value = setup_name_of(this.name.value.trim());
  }

  /// Saves both, or reports why not. A file that was saved from here unchanged is not saved again.
  ///   returns  their names, the set-up undefined if none is needed; null if they are not saved
  private async keep(w: Written): Promise<Kept | null> {
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

  private async keep_and_open(w: Written, open: (kept: Kept) => Promise<void>): Promise<void> {
    const kept = await this.keep(w);
    if (kept) await open(kept);
  }
}

/// The beginning of a text, and how much is left out.
function text_of(whole: string, name: string): HTMLElement {
  const { text, more } = beginning_of(whole, most_shown);
  return h(
    "pre",
    { class: "block-text", tabindex: "0", "aria-label": name },
    text,
    more > 0 && h("span", { class: "dim" }, t("convert_more", { count: more })),
  );
}
