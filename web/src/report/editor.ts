// The report inside an editor (editors/vscode): the view follows the cursor, the cursor follows the view, and the next
// report of the same program replaces the first one in place.
import { Signal } from "../model/signal";

/// What the editor says. `line` counts from 1; `text`: the data of a report, as they are inside one.
export type ToView = { kind: "line"; line: number } | { kind: "report"; text: string };
/// What the view says. `file`: name of a called file; empty: the program itself. `picked`: the user has clicked there.
export type FromView = { kind: "ready" } | { kind: "line"; line: number; file: string; picked: boolean };

/// The part of VS Code's `acquireVsCodeApi()` that is used here.
export interface EditorApi {
  postMessage(message: FromView): void;
}

export class EditorLink {
  readonly on_line = new Signal<number>(); // the cursor is in another line
  readonly on_report = new Signal<string>();
  private shared = 0; // the line in which view and cursor agree: it is not reported back
  private is_open = false; // a report is shown whole, and what changes now is the user's doing

  constructor(private api: EditorApi) {}

  /// Returns null if the report is open in a browser.
  static of_window(): EditorLink | null {
    const acquire = (globalThis as { acquireVsCodeApi?: () => EditorApi }).acquireVsCodeApi;
    if (!acquire) return null;
    const link = new EditorLink(acquire());
    document.documentElement.classList.add("in-editor");
    addEventListener("message", (event: MessageEvent<unknown>) => link.take(event.data));
    return link;
  }

  /// Another report is being opened: where that puts the view must not move the cursor.
  opening(): void {
    this.is_open = false;
  }

  /// Messages of other origins may arrive too; what is not one of the editor's is ignored.
  take(message: unknown): void {
    const m = message as Partial<{ kind: string; line: unknown; text: unknown }> | null;
    if (m?.kind === "line" && typeof m.line === "number" && m.line !== this.shared) {
      this.shared = m.line;
      this.on_line.emit(m.line);
    } else if (m?.kind === "report" && typeof m.text === "string") this.on_report.emit(m.text);
  }

  /// The view shows another instant: moves the cursor, unless it is in that line already. The first instant of a report
  /// is reported as `ready`: the editor answers with the line of the cursor.
  show(line: number): void {
    if (!this.is_open) {
      this.is_open = true;
      this.shared = 0;
      this.api.postMessage({ kind: "ready" });
      return;
    }
    if (line === this.shared) return;
    this.shared = line;
    this.api.postMessage({ kind: "line", line, file: "", picked: false });
  }

  /// The user has clicked on the path, perhaps on that of a called file.
  pick(line: number, file: string): void {
    this.shared = file ? 0 : line;
    this.api.postMessage({ kind: "line", line, file, picked: true });
  }

  /// Calls with the present theme of the editor, and with each later one.
  on_theme(set: (dark: boolean) => void): void {
    const tell = (): void => set(!/\bvscode-(high-contrast-)?light\b/.test(document.body.className));
    new MutationObserver(tell).observe(document.body, { attributeFilter: ["class"] });
    tell();
  }
}
