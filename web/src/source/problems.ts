// Problems in the editor: underlined, a mark in the margin, the hint and the quick fix in the tooltip; updated during
// typing.
import { linter, lintGutter, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import type { EditorState, Text } from "@codemirror/state";
import type { EditorView } from "@codemirror/view";
import type { Fix, Problem } from "../protocol/types";
import { debounce } from "../model/latest";
import type { App } from "../model/app";
import { of_shown_text } from "../model/listed";
import { of_program } from "./problems_of";

const quiet = 120; // ms without a key before the text is checked

export const problem_marks = [linter(null, { delay: 0 }), lintGutter()];

export function watch_problems(app: App, view: EditorView): { changed: () => void; close: () => void } {
  let asked = 0;
  const show = (): void => {
    view.dispatch(
      setDiagnostics(
        view.state,
        diagnostics(
          view.state,
          of_shown_text(app).filter((p) => of_program(p, app.opened?.file ?? "")),
          view,
        ),
      ),
    );
  };
  const check = debounce(quiet, async () => {
    const mine = ++asked;
    try {
      const { problems } = await app.client.ask("check", { text: view.state.doc.toString() });
      if (mine !== asked) return; // a newer text is being checked, this answer belongs to an old one
      app.checked = problems;
      app.on_problems.emit();
    } catch (e) {
      app.tell(e);
    }
  });
  const offs = [
    app.on_problems.on(show),
    app.on_cut.on((part) => {
      if (part === null) show();
    }),
  ];
  show();
  return {
    changed: () => {
      asked++;
      check();
    },
    close: () => {
      asked++;
      for (const off of offs) off();
    },
  };
}

function diagnostics(state: EditorState, problems: Problem[], view: EditorView): Diagnostic[] {
  const severities = { alarm: "error", warning: "warning", advice: "info", note: "info" } as const;
  return problems
    .filter((p) => p.line >= 1 && p.line <= state.doc.lines)
    .slice(0, 2000)
    .map((p) => {
      const [from, to] = span(state.doc, p);
      return {
        from,
        to,
        severity: severities[p.severity] ?? "info",
        message: "",
        renderMessage: () => message(p),
        actions: p.fix ? [{ name: p.fix.text, apply: () => apply_fix(view, p.fix!) }] : [],
      };
    })
    .sort((a, b) => a.from - b.from);
}

function span(doc: Text, p: Problem): [number, number] {
  const line = doc.line(p.line);
  const from = Math.min(line.to, line.from + Math.max(0, (p.column ?? 1) - 1));
  const to = Math.min(line.to, line.from + Math.max(0, (p.end_column ?? (p.column ?? 1) + 1) - 1));
  return [from, Math.max(from, to)];
}

function message(p: Problem): HTMLElement {
  const e = document.createElement("div");
  const text = document.createElement("strong");
  text.textContent = p.text;
  e.append(text);
  if (p.hint) {
    const hint = document.createElement("div");
    hint.className = "hint";
    hint.textContent = p.hint;
    e.append(hint);
  }
  return e;
}

export function apply_fix(view: EditorView, fix: Fix): void {
  if (fix.line < 1 || fix.line > view.state.doc.lines) return;
  const line = view.state.doc.line(fix.line);
  const at = (column: number): number => Math.min(line.to, line.from + Math.max(0, column - 1));
  const from = at(fix.from);
  view.dispatch({ changes: { from, to: Math.max(from, at(fix.to)), insert: fix.insert }, userEvent: "input.fix" });
}
