// Overrides in figures, with −10, +10 and 100 %: a slider cannot be set by a finger in a glove.
import { remember, remembered } from "../model/memory";
import type { Operator } from "../model/operator";
import { bounded_override, most_feed, type Share } from "../model/overrides";
import type { Panel } from "../protocol/types";
import { t } from "../texts/texts";
import { button, h } from "../ui/dom";
import { enable, mark, set, write } from "../ui/update";

interface Row {
  name: Share;
  element: HTMLElement;
  label: HTMLElement;
  value: HTMLElement;
  keys: [HTMLButtonElement, HTMLButtonElement, HTMLButtonElement];
}

export class OverrideRows {
  readonly element = h("section", { class: "override-rows" });
  private rows: Row[];
  private wide = remembered("override_200", false);
  private wanted: Partial<Record<Share, number>> = {}; // asked for, and not yet shown by the machine

  constructor(private operator: Operator) {
    this.rows = (["override", "rapid", "spindle"] as const).map((name) => this.row(name));
    this.element.append(...this.rows.map((r) => r.element));
  }

  /// Lets the feed go up to 200 %.
  set_wide(on: boolean): void {
    this.wide = on;
    remember("override_200", on);
  }
  get is_wide(): boolean {
    return this.wide;
  }

  /// Changes an override by this many percent; null: to 100 %.
  change(name: Share, by: number | null): void {
    const p = this.operator.panel;
    if (!p?.holds) return;
    const now = this.wanted[name] ?? Math.round(100 * p[name]),
      percent = by === null ? 100 : bounded_override(name, now + by, most_feed(this.wide));
    this.wanted[name] = percent;
    void this.operator.ask("switches", { [name]: percent / 100 }).then(() => {
      if (this.wanted[name] === percent) delete this.wanted[name];
    });
  }

  show(p: Panel | null): void {
    set(this.element, "aria-label", t("op_overrides"));
    for (const { name, label, value, keys } of this.rows) {
      const percent = p ? Math.round(100 * p[name]) : 100,
        text = t(`share_${name}`);
      write(label, text);
      write(value, `${percent} %`);
      mark(value, "differs", percent !== 100);
      for (const [i, key] of keys.entries()) {
        set(key, "aria-label", `${text}: ${["−10 %", "100 %", "+10 %"][i]}`);
        enable(key, Boolean(p?.holds));
      }
    }
  }

  private row(name: Share): Row {
    const key = (text: string, by: number | null): HTMLButtonElement => button(text, () => this.change(name, by));
    const label = h("span", { class: "override-name" }),
      value = h("output", { class: "override-value" }),
      keys: Row["keys"] = [key("−10", -10), key("100 %", null), key("+10", 10)];
    return { name, label, value, keys, element: h("div", { class: "override-row" }, label, value, ...keys) };
  }
}
