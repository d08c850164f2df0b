// Stop points, watched expressions, and the open calls.
import type { Operator } from "../model/operator";
import { remember, remembered } from "../model/memory";
import type { Panel } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h, redraw } from "./dom";

const each = 500; // ms between updates

export class WatchPanel {
  readonly element = h("details", { class: "watches" });
  private body = h("div");
  private texts = remembered<string[]>("watches", []);
  private values = new Map<string, number | null>();
  private looked = 0;
  private drawn = "";

  constructor(
    private operator: Operator,
    private show_line: (line: number) => void,
  ) {
    operator.on_panel.on((p) => this.look(p));
    on_language(() => {
      this.drawn = "";
      this.look(operator.panel);
    });
    this.element.addEventListener("toggle", () => this.look(operator.panel));
    this.element.hidden = true;
  }

  private look(p: Panel | null): void {
    this.element.hidden = !p;
    if (!p) return;
    const now = performance.now();
    if (this.element.open && this.texts.length && now - this.looked > each) {
      this.looked = now;
      void this.operator.ask("watch", { expressions: this.texts }, false).then((a) => {
        for (const v of a?.values ?? []) this.values.set(v.text, v.value);
        this.draw(p);
      });
    }
    this.draw(p);
  }

  private draw(p: Panel): void {
    const wanted = JSON.stringify([this.element.open, p.holds, p.stops, p.hit, p.calls, this.texts, [...this.values]]);
    if (wanted === this.drawn) return;
    this.drawn = wanted;
    fill(this.element, h("summary", null, h("b", null, t("debugging"))), this.body);
    if (!this.element.open) return;
    redraw(this.body, () =>
      fill(
        this.body,
        ...this.stops(p),
        ...this.watches(),
        p.calls.length > 0 &&
          h(
            "p",
            null,
            h("b", null, t("open_calls")),
            " ",
            p.calls.map((c) => `${c.what} (${t("line_n", { line: c.line })})`).join(" → "),
          ),
      ),
    );
  }

  private stops(p: Panel): HTMLElement[] {
    const { operator } = this;
    const at_line = h("input", {
        size: "6",
        inputmode: "numeric",
        "aria-label": t("stop_line"),
        placeholder: t("stop_line"),
      }),
      when = h("input", { size: "10", "aria-label": t("stop_condition"), placeholder: "#100 > 5" }),
      tool = h("input", { size: "4", inputmode: "numeric", "aria-label": t("stop_tool"), placeholder: "T" });
    const add = (): void => {
      const n = Number(at_line.value),
        T = Number(tool.value),
        condition = when.value.trim();
      if (n > 0 || T > 0 || condition)
        void operator
          .ask("stops", {
            ...(n > 0 ? { line: n } : {}),
            ...(T > 0 ? { tool: T } : {}),
            ...(condition ? { condition } : {}),
          })
          .then((a) => {
            if (a) for (const i of [at_line, when, tool]) i.value = "";
          });
    };
    return [
      h("h3", null, t("stop_points")),
      h("div", { class: "row wrap" }, at_line, tool, when, button(t("add_stop"), add, { disabled: !p.holds })),
      h(
        "ul",
        { class: "stop-points" },
        ...p.stops.map((s) =>
          h(
            "li",
            { class: `row${s.number === p.hit ? " hit" : ""}` },
            h(
              "span",
              { class: "grow" },
              s.line ? button(t("line_n", { line: s.line }), () => this.show_line(s.line), { class: "link" }) : "",
              [s.tool ? `T${s.tool}` : "", s.call, s.condition].filter(Boolean).join(" · "),
            ),
            button("×", () => void operator.ask("stops", { remove: s.number }), {
              class: "icon",
              disabled: !p.holds,
              "aria-label": t("remove_stop"),
            }),
          ),
        ),
      ),
    ];
  }

  private watches(): HTMLElement[] {
    const text = h("input", {
      size: "12",
      "aria-label": t("watch"),
      placeholder: "#100",
      onkeydown: (e: KeyboardEvent) => {
        if (e.key === "Enter") add();
      },
    });
    const set = (texts: string[]): void => {
      this.texts = texts;
      remember("watches", texts);
      this.looked = 0;
      this.look(this.operator.panel);
    };
    const add = (): void => {
      const s = text.value.trim();
      text.value = "";
      if (s && !this.texts.includes(s)) set([...this.texts, s].slice(-20));
    };
    return [
      h("h3", null, t("watches")),
      h("div", { class: "row" }, text, button(t("add_stop"), add)),
      h(
        "ul",
        { class: "stop-points" },
        ...this.texts.map((s) =>
          h(
            "li",
            { class: "row" },
            h("code", { class: "grow" }, s),
            h(
              "b",
              null,
              this.values.get(s) === null || this.values.get(s) === undefined ? "–" : String(this.values.get(s)),
            ),
            button("×", () => set(this.texts.filter((x) => x !== s)), {
              class: "icon",
              "aria-label": t("remove_watch"),
            }),
          ),
        ),
      ),
    ];
  }
}
