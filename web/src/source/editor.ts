// The editor of a program that is held in the page: undo, search, problems, the running line.
import { defaultKeymap, history, historyKeymap, isolateHistory } from "@codemirror/commands";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { EditorState, Prec, StateEffect, StateField, RangeSet } from "@codemirror/state";
import {
  Decoration,
  EditorView,
  GutterMarker,
  WidgetType,
  type DecorationSet,
  drawSelection,
  gutterLineClass,
  highlightActiveLine,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import type { App } from "../model/app";
import { on_language, t } from "../texts/texts";
import { h } from "../ui/dom";
import { explain } from "./explain";
import { gcode } from "./gcode";
import { phrases, phrases_now } from "./phrases";
import { problem_marks, watch_problems } from "./problems";

export interface SourceView {
  show_line(line: number, beside?: string): void;
  /// Puts the cursor into a line, as a click there does.
  go_to(line: number): void;
  focus(): void;
  close(): void;
  readonly editor?: EditorView;
  /// Replaces the text as one change that undo takes back.
  take?(text: string): void;
  /// Inserts lines after the line of the cursor, as one change that undo takes back.
  insert?(lines: string[]): void;
}

interface Running {
  line: number;
  beside: string;
}
const set_running = StateEffect.define<Running>();
const running_line = Decoration.line({ class: "cm-running" });
const running_gutter = new (class extends GutterMarker {
  override elementClass = "cm-running-number";
})();

/// Values of the variables that the running line uses, after its end.
class Beside extends WidgetType {
  constructor(private text: string) {
    super();
  }
  override eq(other: Beside): boolean {
    return other.text === this.text;
  }
  toDOM(): HTMLElement {
    return h("span", { class: "cm-beside" }, this.text);
  }
}

const running = StateField.define<Running>({
  create: () => ({ line: 0, beside: "" }),
  update(now, tr) {
    for (const e of tr.effects) if (e.is(set_running)) return e.value;
    // In an edited text the mark stays at its block until the next state says otherwise.
    const at = tr.docChanged ? start_of(tr.startState, now.line) : -1;
    return at < 0 ? now : { ...now, line: tr.newDoc.lineAt(tr.changes.mapPos(at, 1)).number };
  },
  provide: (f) => [
    EditorView.decorations.compute([f, "doc"], (s) => running_marks(s, s.field(f))),
    gutterLineClass.compute([f, "doc"], (s) => {
      const at = start_of(s, s.field(f).line);
      return at < 0 ? RangeSet.empty : RangeSet.of(running_gutter.range(at));
    }),
  ],
});
function running_marks(s: EditorState, now: Running): DecorationSet {
  const at = start_of(s, now.line);
  if (at < 0) return Decoration.none;
  const line = running_line.range(at);
  return now.beside
    ? Decoration.set([line, Decoration.widget({ widget: new Beside(now.beside), side: 1 }).range(s.doc.lineAt(at).to)])
    : Decoration.set(line);
}
const start_of = (s: EditorState, line: number): number =>
  line >= 1 && line <= s.doc.lines ? s.doc.line(line).from : -1;

export function editor_view(
  app: App,
  host: HTMLElement,
  text: string,
  picked: (line: number) => void,
  save: () => void,
  save_as?: () => void,
): SourceView {
  let watch: ReturnType<typeof watch_problems> | undefined;
  const view = new EditorView({
    parent: host,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        history(),
        drawSelection(),
        highlightActiveLine(),
        search({ top: true }),
        highlightSelectionMatches(),
        gcode,
        problem_marks,
        explain(app),
        running,
        phrases.of(phrases_now()),
        EditorState.readOnly.of(!app.opened?.editable),
        EditorView.contentAttributes.of({
          tabindex: "0",
          "aria-label": t("source"),
          spellcheck: "false",
          autocapitalize: "characters",
        }),
        Prec.highest(
          EditorView.domEventHandlers({
            keydown: (e) => {
              if (!save_as || !e.shiftKey || !(e.ctrlKey || e.metaKey) || e.code !== "KeyS") return false;
              e.preventDefault();
              save_as();
              return true;
            },
          }),
        ),
        keymap.of([
          {
            key: "Mod-s",
            preventDefault: true,
            run: () => {
              save();
              return true;
            },
          },
          ...defaultKeymap,
          ...historyKeymap,
          ...searchKeymap,
        ]),
        EditorView.updateListener.of((u) => {
          if (u.docChanged) {
            app.set_text(u.state.doc.toString());
            watch?.changed();
          } else if (u.selectionSet && u.transactions.some((tr) => tr.isUserEvent("select")))
            picked(u.state.doc.lineAt(u.state.selection.main.head).number);
        }),
      ],
    }),
  });
  watch = watch_problems(app, view);
  const off = on_language(() => view.dispatch({ effects: phrases.reconfigure(phrases_now()) }));
  return {
    editor: view,
    show_line(line, beside = "") {
      const at = start_of(view.state, line);
      view.dispatch({ effects: set_running.of({ line, beside }) });
      if (at >= 0 && !seen(view, at)) scroll_to_running(view);
    },
    go_to(line) {
      const at = start_of(view.state, line),
        effects = EditorView.scrollIntoView(at, { y: "center" });
      if (at >= 0) view.dispatch({ selection: { anchor: at }, effects, userEvent: "select" });
    },
    take: (text) => take_text(view, text),
    insert: (lines) => {
      const at = view.state.doc.lineAt(view.state.selection.main.head).to,
        insert = lines.map((line) => `\n${line}`).join("");
      view.dispatch({
        changes: { from: at, insert },
        selection: { anchor: at + insert.length },
        annotations: isolateHistory.of("full"),
        scrollIntoView: true,
      });
    },
    focus: () => view.focus(),
    close: () => {
      off();
      watch?.close();
      view.destroy();
    },
  };
}

/// Changes only what differs, so that cursor and marks outside of it stay.
function take_text(view: EditorView, text: string): void {
  const before = view.state.doc.toString(),
    shorter = Math.min(before.length, text.length);
  let from = 0,
    end = 0;
  while (from < shorter && before[from] === text[from]) from++;
  while (end < shorter - from && before[before.length - 1 - end] === text[text.length - 1 - end]) end++;
  view.dispatch({
    changes: { from, to: before.length - end, insert: text.slice(from, text.length - end) },
    annotations: isolateHistory.of("full"),
    scrollIntoView: true,
  });
}

/// Scrolls to the running line. The heights of a text that was hidden until now are guesses, and another line may run
/// before the editor has scrolled to this one: so it is looked whether the line that runs then has come into view.
function scroll_to_running(view: EditorView, tries = 3): void {
  const at = start_of(view.state, view.state.field(running).line);
  if (at < 0) return;
  view.dispatch({ effects: EditorView.scrollIntoView(at, { y: "center" }) });
  const again = (): void => {
    if (view.dom.isConnected && !drawn_in_view(view, view.state.field(running).line))
      scroll_to_running(view, tries - 1);
  };
  if (tries > 0) requestAnimationFrame(() => setTimeout(again));
}

/// As it is drawn, not as the editor reckons. A text that is hidden has no better place to go to.
function drawn_in_view(view: EditorView, line: number): boolean {
  const at = start_of(view.state, line),
    box = view.scrollDOM.getBoundingClientRect(),
    drawn = at < 0 || box.height === 0 ? box : view.coordsAtPos(at);
  return drawn !== null && drawn.top >= box.top - 1 && drawn.bottom <= box.bottom + 1;
}

/// True if the line is visible, so that the text does not jump while the slider moves. Without a height it has not been
/// measured yet.
function seen(view: EditorView, at: number): boolean {
  const block = view.lineBlockAt(at),
    box = view.scrollDOM;
  return block.height > 0 && block.top >= box.scrollTop && block.bottom <= box.scrollTop + box.clientHeight;
}
