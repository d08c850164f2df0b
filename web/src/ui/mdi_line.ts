// A line by hand (MDI) with its history and undo.
import { remember, remembered } from "../model/memory";
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";

const most_history = 50;

export class MdiLine {
  readonly element = h("div", { class: "row mdi-row" });
  private line = h("input", {
    class: "mdi wide",
    placeholder: "G0 X10",
    spellcheck: "false",
    autocapitalize: "characters",
    onkeydown: (e: KeyboardEvent) => this.key(e),
  });
  private go = button("", () => this.enter());
  private back = button("", () => void this.operator.ask("undo", {}));
  private history = remembered<string[]>("mdi", []);
  private at = -1; // in the history; -1: a new line
  private may = false;
  private undone = "";

  constructor(private operator: Operator) {
    fill(this.element, this.line, this.go, this.back);
    on_language(() => this.name());
    this.name();
  }

  show(p: Panel): void {
    this.may = p.holds && ["standing", "ended"].includes(p.mode);
    if (this.go.disabled === this.may) this.go.disabled = !this.may;
    this.back.hidden = Boolean(p.real);
    const can_undo = this.may && p.can_undo > 0;
    if (this.back.disabled === can_undo) this.back.disabled = !can_undo;
    const undone = `${t("undo_line")}${p.can_undo ? ` (${p.can_undo})` : ""}`;
    if (undone !== this.undone) this.back.textContent = this.undone = undone;
  }

  private name(): void {
    this.line.setAttribute("aria-label", t("mdi"));
    this.go.textContent = t("enter_line");
    this.back.title = t("undo_line_long");
    this.back.textContent = this.undone = t("undo_line");
  }

  private key(e: KeyboardEvent): void {
    if (e.key === "Enter" && this.may) return this.enter();
    const way = e.key === "ArrowUp" ? 1 : e.key === "ArrowDown" ? -1 : 0;
    if (!way) return;
    e.preventDefault();
    this.at = Math.min(this.history.length - 1, Math.max(-1, this.at + way));
    this.line.value = this.at < 0 ? "" : this.history[this.at]!;
  }

  private enter(): void {
    const text = this.line.value.trim();
    if (!text) return;
    this.history = [text, ...remembered<string[]>("mdi", []).filter((x) => x !== text)].slice(0, most_history);
    remember("mdi", this.history);
    this.at = -1;
    this.line.value = "";
    void this.operator.ask("enter", { line: text });
  }
}
