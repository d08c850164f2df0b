// Problems, grouped by type: a group of 400 equal warnings is one row with a count.
import type { App } from "../model/app";
import { is_of_cut, listed, listed_of_cut } from "../model/listed";
import type { Fix, Problem } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { clock } from "./figures";
import { icon } from "./icons";

const grave = { alarm: 0, warning: 1, advice: 2, note: 3 } as const;

export interface Group {
  key: string;
  id: string;
  severity: Problem["severity"];
  problems: Problem[];
}

/// Alarms first, then the groups in the order of their first line.
export function grouped_problems(problems: Problem[]): Group[] {
  const by = new Map<string, Group>();
  for (const p of problems) {
    const key = `${p.severity}:${p.id}${is_of_cut(p) ? ":cut" : ""}`,
      g = by.get(key);
    if (g) g.problems.push(p);
    else by.set(key, { key, id: p.id, severity: p.severity, problems: [p] });
  }
  return [...by.values()].sort(
    (a, b) => grave[a.severity] - grave[b.severity] || a.problems[0]!.line - b.problems[0]!.line,
  );
}

/// A part of the one list as rows; a click goes to the line and the moment.
export class ProblemRows {
  private open = new Set<string>();

  constructor(
    private app: App,
    private jump: (p: Problem) => void,
    private fix: (f: Fix) => void,
  ) {}

  /// `told_whence`: marks the rows that come from the cut.
  rows(problems: Problem[], told_whence: boolean): HTMLElement[] {
    return grouped_problems(problems).map((g) => this.group(g, told_whence));
  }

  private group(g: Group, told_whence: boolean): HTMLElement {
    const first = g.problems[0]!;
    if (g.problems.length === 1) return this.row(first, true, told_whence);
    const e = h(
      "details",
      {
        class: `problem-group ${g.severity}`,
        open: this.open.has(g.key),
        ontoggle: () => {
          if (e.open) this.open.add(g.key);
          else this.open.delete(g.key);
        },
      },
      h(
        "summary",
        null,
        icon(g.severity, t(g.severity)),
        h("span", { class: "problem-text" }, first.text),
        told_whence && is_of_cut(first) && h("span", { class: "whence" }, t("of_cut")),
        h("span", { class: "count" }, String(g.problems.length)),
      ),
      first.hint && h("div", { class: "hint" }, first.hint),
      ...g.problems.slice(0, 500).map((p) => this.row(p, false, false)),
      g.problems.length > 500 && h("p", { class: "note" }, `… +${g.problems.length - 500}`),
    );
    return e;
  }

  private row(p: Problem, alone: boolean, told_whence: boolean): HTMLElement {
    const of_cut = is_of_cut(p);
    return h(
      "div",
      { class: `problem ${p.severity}`, "data-id": p.id },
      h(
        "button",
        { type: "button", class: "problem-go", onclick: () => this.jump(p) },
        alone && icon(p.severity, t(p.severity)),
        h("span", { class: "problem-text" }, p.text),
        h(
          "span",
          { class: "dim" },
          told_whence && of_cut && h("span", { class: "whence" }, t("of_cut")),
          [p.number, t("line_n", { line: p.line }), of_cut && clock(p.at)].filter(Boolean).join(" · "),
        ),
      ),
      alone && p.hint && h("div", { class: "hint" }, p.hint),
      p.fix && this.app.opened?.editable && button(p.fix.text, () => this.fix(p.fix!), { class: "fix" }),
    );
  }
}

/// The whole list.
export class ProblemsPanel {
  readonly element = h("div", { class: "problems" });
  private list: ProblemRows;

  constructor(
    private app: App,
    jump: (p: Problem) => void,
    fix: (f: Fix) => void,
  ) {
    this.list = new ProblemRows(app, jump, fix);
    app.on_problems.on(() => this.draw());
    app.on_done.on(() => this.draw());
    app.on_cut.on((part) => {
      if (part === null || part === 0) this.draw();
    });
    on_language(() => this.draw());
    this.draw();
  }

  badge(): string {
    return String(listed(this.app).length || "");
  }

  private draw(): void {
    const rows = this.list.rows(listed(this.app), true);
    fill(
      this.element,
      ...(rows.length ? rows : [h("p", { class: "note" }, this.app.opened ? t("no_problems") : t("open_a_program"))]),
    );
  }
}

/// The findings of the cut, as a part of the list.
export class CutProblems {
  private list: ProblemRows;

  constructor(
    private app: App,
    jump: (p: Problem) => void,
  ) {
    this.list = new ProblemRows(app, jump, () => undefined);
  }

  badge(): string {
    return String(listed_of_cut(this.app).length || "");
  }

  rows(): HTMLElement[] {
    const { cut } = this.app,
      found = listed_of_cut(this.app);
    if (cut && !cut.error && !found.length) return [h("p", { class: "good" }, t("nothing_hit"))];
    return this.list.rows(found, false);
  }
}
