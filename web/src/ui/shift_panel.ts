// The log of the shift: what ran, when, stops, alarms, overrides. It can be saved as CSV.
import type { Operator } from "../model/operator";
import type { LogEntry } from "../protocol/types";
import { on_language, t, type TextKey } from "../texts/texts";
import { button, fill, h } from "./dom";

const most_shown = 500;

export class ShiftPanel {
  readonly element = h("details", { class: "shift" });
  private body = h("div");
  private log: LogEntry[] = [];

  constructor(private operator: Operator) {
    const head = (): void => fill(this.element, h("summary", null, h("b", null, t("shift"))), this.body);
    head();
    on_language(() => {
      head();
      this.draw();
    });
    this.element.addEventListener("toggle", () => void this.load());
    operator.on_panel.on((p) => {
      this.element.hidden = !p;
    });
    operator.on_stood.on(() => void this.load());
    this.element.hidden = true;
  }

  private async load(): Promise<void> {
    if (!this.element.open || !this.operator.panel) return;
    this.log = (await this.operator.ask("shift", {}, false))?.log ?? this.log;
    this.draw();
  }

  private draw(): void {
    const time = (e: LogEntry): string => new Date(e.at).toLocaleString();
    fill(
      this.body,
      h(
        "div",
        { class: "row" },
        button(t("tables_again"), () => void this.load()),
        button(t("shift_export"), () => this.save(), { disabled: !this.log.length }),
      ),
      h(
        "table",
        { class: "table-rows" },
        h(
          "tbody",
          null,
          ...this.log
            .slice(-most_shown)
            .reverse()
            .map((e) =>
              h(
                "tr",
                { class: ["alarm", "emergency"].includes(e.kind) ? "differs" : "" },
                h("td", { class: "dim" }, time(e)),
                h("th", { scope: "row" }, t(`shift_${e.kind}` as TextKey)),
                h("td", null, e.line ? t("line_n", { line: e.line }) : ""),
                h("td", null, e.text),
              ),
            ),
        ),
      ),
    );
  }

  private save(): void {
    const quoted = (s: string): string => `"${s.replace(/"/g, '""')}"`;
    const text = [
      "time;what;line;text",
      ...this.log.map((e) => [e.at, e.kind, e.line || "", e.text].map((x) => quoted(String(x))).join(";")),
    ].join("\r\n");
    const a = h("a", {
      href: URL.createObjectURL(new Blob(["\ufeff", text], { type: "text/csv" })),
      download: `${(this.operator.name ?? "kadr").replace(/.*\//, "")}.csv`,
    });
    a.click();
    URL.revokeObjectURL(a.href);
  }
}
