// All problems, grouped by what is wrong: a group of 400 equal warnings is one row with a count.
import type { App } from "../model/app";
import type { Fix, Problem } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { icon } from "./icons";

const grave = { alarm: 0, warning: 1, advice: 2, note: 3 } as const;

export interface Group {
  id: string;
  severity: Problem["severity"];
  problems: Problem[];
}

/// Alarms first, then the groups in the order of their first line.
export function grouped_problems(problems: Problem[]): Group[] {
  const by = new Map<string, Group>();
  for (const p of problems) {
    const key = `${p.severity}:${p.id}`,
      g = by.get(key);
    if (g) g.problems.push(p);
    else by.set(key, { id: p.id, severity: p.severity, problems: [p] });
  }
  return [...by.values()].sort(
    (a, b) => grave[a.severity] - grave[b.severity] || a.problems[0]!.line - b.problems[0]!.line,
  );
}

export class ProblemsPanel {
  readonly element = h("div", { class: "problems" });
  private open = new Set<string>();

  constructor(
    private app: App,
    private jump: (p: Problem) => void,
    private fix: (f: Fix) => void,
  ) {
    app.on_problems.on(() => this.draw());
    app.on_done.on(() => this.draw());
    on_language(() => this.draw());
    this.draw();
  }

  /// What the run met, and what the text as it is typed would meet, without the same place twice.
  static all(app: App): Problem[] {
    if (!app.checked) return app.problems;
    return app.dirty
      ? app.checked
      : [...app.problems, ...app.checked.filter((c) => !app.problems.some((p) => p.id === c.id && p.line === c.line))];
  }

  private draw(): void {
    const groups = grouped_problems(ProblemsPanel.all(this.app));
    fill(
      this.element,
      ...(groups.length
        ? groups.map((g) => this.group(g))
        : [h("p", { class: "note" }, this.app.opened ? t("no_problems") : t("open_a_program"))]),
    );
  }

  private group(g: Group): HTMLElement {
    const key = `${g.severity}:${g.id}`,
      first = g.problems[0]!;
    if (g.problems.length === 1) return this.row(first, true);
    const e = h(
      "details",
      {
        class: `problem-group ${g.severity}`,
        open: this.open.has(key),
        ontoggle: () => {
          if (e.open) this.open.add(key);
          else this.open.delete(key);
        },
      },
      h(
        "summary",
        null,
        icon(g.severity, t(g.severity)),
        h("span", { class: "problem-text" }, first.text),
        h("span", { class: "count" }, String(g.problems.length)),
      ),
      first.hint && h("div", { class: "hint" }, first.hint),
      ...g.problems.slice(0, 500).map((p) => this.row(p, false)),
      g.problems.length > 500 && h("p", { class: "note" }, `… +${g.problems.length - 500}`),
    );
    return e;
  }

  private row(p: Problem, alone: boolean): HTMLElement {
    return h(
      "div",
      { class: `problem ${p.severity}` },
      h(
        "button",
        { type: "button", class: "problem-go", onclick: () => this.jump(p) },
        alone && icon(p.severity, t(p.severity)),
        h("span", { class: "problem-text" }, p.text),
        h("span", { class: "dim" }, `${p.number ? `${p.number} · ` : ""}${t("line_n", { line: p.line })}`),
      ),
      alone && p.hint && h("div", { class: "hint" }, p.hint),
      p.fix && this.app.opened?.editable && button(p.fix.text, () => this.fix(p.fix!), { class: "fix" }),
    );
  }
}
