// "Write blocks": drilling cycles of this control, an arc by three points, a corner. The control's own interpreter checks
// the program with the new blocks before they can be inserted.
import type { App } from "../model/app";
import { debounce } from "../model/latest";
import { remember, remembered } from "../model/memory";
import type { Problem, WrittenBlocks } from "../protocol/types";
import { t, type TextKey } from "../texts/texts";
import { open_dialog } from "../ui/dialog";
import { button, fill, h, option } from "../ui/dom";
import { toast } from "../ui/toast";
import { blocks_question, kinds, motion_at, with_lines, type BlocksKind, type BlocksValues } from "./blocks_form";
import { sketch } from "./blocks_sketch";

const pause = 300; // ms after the last key before the blocks are written again

export interface BlocksVerbs {
  selected(): { from: number; to: number } | null;
  insert(lines: string[]): void;
}

export class BlocksDialog {
  private dialog: HTMLDialogElement;
  private kind: BlocksKind = remembered<BlocksKind>("blocks_kind", "cycle");
  private values: BlocksValues = remembered<BlocksValues>("blocks_values", {});
  private table: WrittenBlocks | null = null;
  private lines: string[] = [];
  private fields = h("form", { class: "edit-fields", onsubmit: (e: Event) => e.preventDefault() });
  private told = h("div", { class: "edit-told", role: "status", "aria-live": "polite" });
  private shown = h("pre", { class: "block-text", tabindex: "0", "aria-label": t("blocks_made") });
  private insert = button(t("blocks_insert"), () => this.put_in(), { class: "main", disabled: true });
  private asked = 0;
  private soon = debounce(pause, () => void this.ask());

  constructor(
    private app: App,
    private verbs: BlocksVerbs,
  ) {
    const which = h(
      "select",
      { name: "blocks", "aria-label": t("blocks_kind"), onchange: () => this.choose(which.value as BlocksKind) },
      ...kinds.map((kind) => option(kind, t(`blocks_${kind}`), kind === this.kind)),
    );
    const here = app.opened!.file;
    const off = app.on_opening.on((file) => {
      if (file !== here) this.dialog.close();
    });
    this.dialog = open_dialog(
      t("blocks_title"),
      h(
        "div",
        { class: "edit" },
        h("label", { class: "edit-row" }, h("span", null, t("blocks_kind")), which),
        this.fields,
        this.told,
        this.shown,
        h("div", { class: "row" }, this.insert, h("span", { class: "note" }, t("blocks_where"))),
      ),
      { docked: "left", closed: off },
    );
    which.focus();
    void this.begin();
  }

  private async begin(): Promise<void> {
    try {
      if (!(await this.app.run_shown())) return;
      this.table = await this.app.client.ask("write_blocks", { what: "cycles" });
    } catch (e) {
      this.app.tell(e);
    }
    this.draw();
    void this.ask();
  }

  private choose(kind: BlocksKind): void {
    this.kind = kind;
    remember("blocks_kind", kind);
    this.draw();
    void this.ask();
  }

  private set(name: string, value: string): void {
    this.values[name] = value;
    remember("blocks_values", this.values);
    this.soon();
  }

  private get cycle() {
    return this.table?.cycles.find((one) => one.code === this.values.cycle) ?? this.table?.cycles[0];
  }

  private draw(): void {
    const point = (name: string, text: TextKey): HTMLElement =>
      h(
        "div",
        { class: "edit-row pair" },
        h("span", null, t(text)),
        this.input(`${name}_x`, `${t(text)} X`, "X"),
        this.input(`${name}_y`, `${t(text)} Y`, "Y"),
      );
    const rows =
      this.kind === "cycle"
        ? this.cycle_rows()
        : this.kind === "arc"
          ? [point("from", "blocks_from"), point("through", "blocks_through"), point("to", "blocks_to")]
          : [
              this.row(
                t("blocks_corner_kind"),
                this.select("kind", t("blocks_corner_kind"), [
                  ["rounding", t("blocks_rounding")],
                  ["chamfer", t("blocks_chamfer")],
                ]),
              ),
              this.row(t("blocks_size"), this.input("size", t("blocks_size"))),
              point("from", "blocks_from"),
              point("corner", "blocks_corner_at"),
              point("to", "blocks_to"),
            ];
    fill(this.fields, sketch(this.kind), ...rows);
  }

  private cycle_rows(): HTMLElement[] {
    const { table, cycle } = this;
    if (!table || !cycle) return [h("p", { class: "note" }, t("blocks_no_cycles"))];
    const names: Record<string, TextKey> = {
      Z: "blocks_z",
      R: "blocks_r",
      Q: "blocks_q",
      P: "blocks_p",
      F: "blocks_f",
    };
    const holes = h("textarea", {
      name: "holes",
      rows: "4",
      "aria-label": t("blocks_holes"),
      placeholder: "10 20\n30 20",
      oninput: () => this.set("holes", holes.value),
    });
    holes.value = this.values.holes ?? "";
    const cycles = this.select(
      "cycle",
      t("blocks_cycle"),
      table.cycles.map((one) => [one.code, `${one.code}  ${one.title}`]),
      true,
    );
    return [
      this.row(t("blocks_cycle"), cycles),
      ...(table.retract.length
        ? [
            this.row(
              t("blocks_retract"),
              this.select("retract", t("blocks_retract"), [
                ["", t("blocks_as_before")],
                ...table.retract.map((one) => [one.code, `${one.code}  ${one.title}`] as [string, string]),
              ]),
            ),
          ]
        : []),
      ...cycle.words.map((word) =>
        this.row(
          `${word.letter}: ${t(names[word.letter]!)}${word.needed ? "" : ` (${t("blocks_optional")})`}`,
          this.input(word.letter, t(names[word.letter]!)),
        ),
      ),
      this.row(t("blocks_holes"), holes),
    ];
  }

  private row(text: string, input: HTMLElement): HTMLElement {
    return h("label", { class: "edit-row" }, h("span", null, text), input);
  }
  private input(name: string, label: string, placeholder = ""): HTMLInputElement {
    const input = h("input", {
      name,
      value: this.values[name] ?? "",
      "aria-label": label,
      placeholder,
      inputmode: "decimal",
      autocomplete: "off",
      oninput: () => this.set(name, input.value),
    });
    return input;
  }
  private select(name: string, label: string, choices: [string, string][], draws = false): HTMLSelectElement {
    const select = h(
      "select",
      {
        name,
        "aria-label": label,
        onchange: () => {
          this.set(name, select.value);
          if (draws) this.draw();
        },
      },
      ...choices.map(([value, text]) => option(value, text, value === this.values[name])),
    );
    return select;
  }

  /// Writes the blocks and lets the control check the program with them.
  private async ask(): Promise<void> {
    const mine = ++this.asked,
      { app } = this;
    const question = blocks_question(this.kind, this.values, this.cycle, app.done?.units ?? "mm");
    this.lines = [];
    let told: HTMLElement[] = [h("p", { class: "note" }, t("blocks_fill_in"))],
      lines: string[] = [];
    const after = this.verbs.selected()?.to ?? 0,
      motion = motion_at(app.state, after);
    if (question && motion === null) told = [h("p", { class: "hint error" }, t("blocks_no_line"))];
    else if (question && app.text !== null && this.dialog.open)
      try {
        lines = (await app.client.ask("write_blocks", { ...question, motion: motion!, after })).lines;
        const faults = await this.faults(lines);
        told = faults.length
          ? [h("p", { class: "hint error" }, t("blocks_refused")), ...faults.map((p) => h("p", null, p.text))]
          : [h("p", { class: "good" }, t("blocks_right"))];
        if (mine === this.asked && !faults.length) this.lines = lines;
      } catch (e) {
        told = [h("p", { class: "hint error" }, e instanceof Error ? e.message : String(e))];
      }
    if (mine !== this.asked) return;
    fill(this.told, ...told);
    this.shown.textContent = lines.join("\n");
    this.shown.hidden = !lines.length;
    this.insert.disabled = !this.lines.length || !app.opened?.editable;
  }

  /// Alarms that the control raises because of the new lines: those that the program does not have without them.
  private async faults(lines: string[]): Promise<Problem[]> {
    const { app } = this,
      after = this.verbs.selected()?.to ?? 0;
    const found = async (text: string): Promise<Problem[]> =>
      (await app.client.ask("check", { text })).problems.filter((p) => p.severity === "alarm");
    const [before, now] = [await found(app.text!), await found(with_lines(app.text!, after, lines))];
    const known = new Set(before.map((p) => p.text));
    return now.filter((p) => !known.has(p.text));
  }

  private put_in(): void {
    if (!this.lines.length) return;
    const { lines } = this;
    this.dialog.close();
    this.verbs.insert(lines);
    toast(t("edit_taken"));
  }
}
