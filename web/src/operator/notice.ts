// What the program or the machine says to the operator, large: the text of M0, messages, questions, alarms.
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import { t } from "../texts/texts";
import { button, fill, h } from "../ui/dom";
import { alarm_told } from "../model/alarm_told";
import { comments_of } from "../model/comments";
import type { Blocks } from "./blocks";

export class Notice {
  readonly element = h("div", { class: "notice", role: "alert", hidden: true });
  private drawn = "";

  constructor(
    private operator: Operator,
    private blocks: Blocks,
    private to_line: (line: number) => void,
    private control: () => string | undefined,
  ) {}

  show(p: Panel | null): void {
    const stop = p ? this.stop(p) : "",
      wanted = p
        ? JSON.stringify([p.alarm, p.told, p.asks, p.holds, p.why, stop, p.goes_there, p.not_kept, p.takes_tables])
        : "";
    if (wanted === this.drawn) return;
    this.drawn = wanted;
    const told = p ? this.all(p, stop) : [];
    this.element.hidden = !told.length;
    this.element.classList.toggle("alarm", Boolean(p?.alarm));
    fill(this.element, ...told);
  }

  private all(p: Panel, stop: string): HTMLElement[] {
    const said: (HTMLElement | false | "")[] = [
      p.alarm &&
        h(
          "p",
          { class: "told alarm" },
          alarm_told(p.alarm),
          p.alarm.hint ? ` ${p.alarm.hint}` : "",
          " ",
          p.alarm.line > 0 && this.line_button(p),
        ),
      p.told && h("p", { class: "told" }, p.told),
      stop && h("p", { class: "told" }, stop),
      p.asks && this.answers(p),
      p.goes_there && h("p", { class: "told" }, t("goes_there")),
      p.takes_tables && h("p", { class: "note" }, t("takes_tables")),
      p.not_kept && h("p", { class: "told alarm" }, t("not_kept", { why: p.not_kept })),
    ].map((x) => x || false);
    return said.filter((x): x is HTMLElement => x instanceof HTMLElement);
  }

  /// The code that stopped the program, with its comment.
  private stop(p: Panel): string {
    if (!p.why || p.mode !== "standing") return "";
    if (p.why === "restart") return t("why_restart");
    const said = p.stop_line ? comments_of(p.stop_text ?? this.blocks.line(p.stop_line), this.control()) : "";
    return said ? `${p.why}: ${said}` : t("stands_by", { code: p.why });
  }

  private line_button(p: Panel): HTMLElement {
    const { file, line, file_name } = p.alarm!;
    if (file !== 0) return h("span", null, `${file_name ?? ""}:${line}`);
    return button(t("line_n", { line }), () => this.to_line(line), { class: "to-line" });
  }

  private answers(p: Panel): HTMLElement {
    const answers = [
      ["answer_ok", 1],
      ["answer_yes", 2],
      ["answer_no", 3],
      ["answer_cancel", 0],
    ] as const;
    return h(
      "div",
      { class: "row" },
      ...answers.map(([text, answer]) =>
        button(t(text), () => void this.operator.ask("answer", { answer }), { disabled: !p.holds, "data-starts": "" }),
      ),
    );
  }
}
