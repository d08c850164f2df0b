// The tab of messages: alarms and messages of the machine, what the check found, the log of the shift, settings.
import { alarm_told } from "../model/alarm_told";
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "../ui/dom";
import type { OverrideRows } from "./override_rows";
import { Borrowed } from "./parts";

interface Said {
  at: Date;
  kind: "alarm" | "told";
  text: string;
  line: number;
}
const most = 50;

export class MessagesTab {
  readonly element = h("div", { class: "panel-tab messages-tab operator" });
  private list = h("ul", { class: "said", "aria-live": "polite" });
  private problems_title = h("h3");
  private wide = h("input", { type: "checkbox", onchange: () => this.overrides.set_wide(this.wide.checked) });
  private wide_text = h("span");
  private said: Said[] = [];
  private last = { alarm: "", told: "" };
  private told_badge = "";
  private borrowed: Borrowed[];

  constructor(
    private operator: Operator,
    shift: HTMLDetailsElement,
    problems: HTMLElement,
    private overrides: OverrideRows,
    private to_line: (line: number) => void,
  ) {
    this.borrowed = [new Borrowed(problems), new Borrowed(shift)];
    this.wide.checked = overrides.is_wide;
    this.element.append(this.list, this.problems_title);
    on_language(() => this.draw());
    this.draw();
  }

  open(): void {
    for (const b of this.borrowed) b.take(this.element);
    this.element.append(h("label", { class: "tick" }, this.wide, this.wide_text));
    this.draw();
  }
  close(): void {
    for (const b of this.borrowed) b.give_back();
    this.element.querySelector(".tick")?.remove();
  }

  badge(): string {
    return this.operator.panel?.alarm ? "!" : "";
  }
  badge_changed(): boolean {
    const changed = this.badge() !== this.told_badge;
    this.told_badge = this.badge();
    return changed;
  }

  show(p: Panel | null): void {
    const alarm = p?.alarm ? `${p.alarm.line}:${p.alarm.text}` : "",
      told = p?.told ?? "";
    let changed = false;
    if (alarm && alarm !== this.last.alarm) {
      this.say({
        at: new Date(),
        kind: "alarm",
        text: [alarm_told(p!.alarm!), p!.alarm!.hint].filter(Boolean).join(" "),
        line: p!.alarm!.file === 0 ? p!.alarm!.line : 0,
      });
      changed = true;
    }
    if (told && told !== this.last.told) {
      this.say({ at: new Date(), kind: "told", text: told, line: p!.file === 0 ? p!.line : 0 });
      changed = true;
    }
    this.last = { alarm, told };
    if (changed) this.draw();
  }

  private say(what: Said): void {
    this.said = [what, ...this.said].slice(0, most);
  }

  private draw(): void {
    this.problems_title.textContent = t("problems");
    this.wide_text.textContent = t("op_200");
    fill(
      this.list,
      ...(this.said.length
        ? this.said.map((s) =>
            h(
              "li",
              { class: s.kind },
              h("span", { class: "dim" }, s.at.toLocaleTimeString()),
              " ",
              s.text,
              " ",
              s.line > 0 && button(t("line_n", { line: s.line }), () => this.to_line(s.line), { class: "to-line" }),
            ),
          )
        : [h("li", { class: "note" }, t("op_no_messages"))]),
    );
  }
}
