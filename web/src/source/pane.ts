// The source pane: the editor, or the virtual view of a long file or of a called file; line and slider follow each
// other.
import type { App } from "../model/app";
import { Signal } from "../model/signal";
import { t, on_language } from "../texts/texts";
import { button, fill, h } from "../ui/dom";
import { save } from "../ui/save";
import type { editor_view, SourceView } from "./editor";
import { virtual_view } from "./virtual";
import type { apply_fix } from "./problems";
import type { Fix, State } from "../protocol/types";

const of_machine = -1; // instead of a file's number: the program as a machine runs it
const called_lines = 10_000_000; // the length of a called file is unknown; after its end `source` returns nothing

/// The functions that an editable text needs; a report has none.
export interface Editing {
  view: typeof editor_view;
  fix: typeof apply_fix;
  save_as?(): void;
}

export class SourcePane {
  readonly element = h("section", { class: "pane source", "aria-label": "" });
  private title = h("span", { class: "pane-title" });
  private tools = h("span", { class: "pane-tools" });
  private host = h("div", { class: "source-host" });
  readonly body = h("div", { class: "source-body" }, this.host); // the text and what stands next to it
  readonly on_view = new Signal<SourceView>(); // another text is shown
  readonly on_cursor = new Signal<number>(); // the user has picked a line of the program
  private view: SourceView | null = null;
  private shown_file = 0;
  private name = "";
  private other: (() => void) | null = null; // the machine runs another text: shows that text

  constructor(
    private app: App,
    private picked: (line: number, file: number) => void,
    private editing: Editing | null = null,
  ) {
    this.element.append(h("header", { class: "pane-head" }, this.title, this.tools), this.body);
    app.on_opened.on(() => this.show_program());
    app.on_dirty.on(() => this.head());
    app.on_state.on((s) => {
      if (!s || this.shown_file === of_machine) return;
      const file = s.file ?? 0;
      if (file !== this.shown_file) this.show_file(file, s.file_name ?? "");
      this.view?.show_line(s.line, beside(s));
    });
    on_language(() => this.head());
    this.head();
  }

  show(line: number): void {
    if (this.shown_file !== 0) this.show_file(0, "");
    this.view?.show_line(line);
  }
  /// Puts the cursor into a line of the program, as a click there does.
  go_to(line: number, focus: boolean): void {
    if (this.shown_file !== 0) this.show_file(0, "");
    this.view?.go_to(line);
    if (focus) this.view?.focus();
  }
  /// Shows the program as a machine runs it, if it differs from the editor's text; null: removes it.
  show_machine(text: string | null): void {
    if (text === null) {
      if (this.shown_file === of_machine) this.show_file(0, "");
      return;
    }
    const lines = text.replace(/\n$/, "").split("\n"),
      from_line = async (from: number, count: number): Promise<string[]> => lines.slice(from - 1, from - 1 + count);
    this.replace_view(of_machine, () =>
      virtual_view(
        this.host,
        lines.length,
        from_line,
        () => undefined,
        (line, told) => this.explained(line, told),
      ),
    );
    this.head();
  }
  get shows_machine(): boolean {
    return this.shown_file === of_machine;
  }
  /// Marks the line that the machine executes; 0: none.
  mark_machine(line: number): void {
    if (this.shown_file === 0 || this.shows_machine) this.view?.show_line(line);
  }
  /// Reports that the machine runs another text than the shown one; `show` displays that text.
  tell_machine(show: (() => void) | null): void {
    if (Boolean(show) === Boolean(this.other)) return;
    this.other = show;
    this.head();
  }
  /// Puts a text into the editor as one change that undo takes back.
  take(text: string): void {
    if (this.shown_file !== 0) this.show_file(0, "");
    this.view?.take?.(text);
    this.view?.focus();
  }
  /// Inserts lines after the line of the cursor, as one change; the cursor is after them.
  insert(lines: string[]): void {
    if (this.shown_file === 0) this.view?.insert?.(lines);
    this.view?.focus();
  }
  /// The first and the last line of the selection; null without an editor.
  selected(): { from: number; to: number } | null {
    const state = this.shown_file === 0 ? this.view?.editor?.state : undefined;
    if (!state) return null;
    const { from, to } = state.selection.main;
    return { from: state.doc.lineAt(from).number, to: state.doc.lineAt(to).number };
  }
  /// Places a message between the title and the text.
  tell_above(notice: HTMLElement): void {
    this.body.before(notice);
  }
  fix(fix: Fix): void {
    if (this.view?.editor) {
      this.editing?.fix(this.view.editor, fix);
      this.view.focus();
    }
  }

  private show_program(): void {
    const { app } = this;
    // The editor keeps its undo and its cursor while the same text runs again.
    if (
      this.view?.editor &&
      this.shown_file === 0 &&
      this.name === app.opened?.file &&
      this.view.editor.state.doc.toString() === app.text
    )
      return this.head();
    if (this.shows_machine && this.name === app.opened?.file) return this.head();
    this.name = app.opened?.file ?? "";
    this.show_file(0, "");
  }

  private show_file(file: number, name: string): void {
    const { app } = this;
    const picked = (line: number): void => {
      this.picked(line, file);
      if (file === 0) this.on_cursor.emit(line);
    };
    this.replace_view(file, () => {
      if (file === 0 && app.text !== null && this.editing)
        return this.editing.view(app, this.host, app.text, picked, () => void save(app), this.editing.save_as);
      return virtual_view(
        this.host,
        file === 0 ? (app.opened?.lines ?? 0) : called_lines,
        async (from, count) => (await app.client.ask("source", file ? { from, count, file } : { from, count })).lines,
        picked,
        (line, text) => this.explained(line, text),
      );
    });
    this.head(name);
  }
  private replace_view(file: number, made: () => SourceView): void {
    this.view?.close();
    this.host.replaceChildren();
    this.shown_file = file;
    this.view = made();
    this.on_view.emit(this.view);
  }

  private async explained(line: number, text: string): Promise<string> {
    const { words } = await this.app.client.ask("explain", { line, text });
    return words.map((w) => `${w.code}  ${w.title}`).join("\n");
  }

  private head(called = ""): void {
    const { app } = this;
    this.element.setAttribute("aria-label", t("source"));
    fill(
      this.title,
      called || app.opened?.file || t("source"),
      this.shows_machine && h("span", { class: "note" }, ` ${t("as_machine_runs")}`),
      app.dirty && h("span", { class: "dirty", title: t("unsaved") }, " ●"),
    );
    fill(
      this.tools,
      this.other &&
        !this.shows_machine &&
        h(
          "span",
          { class: "machine-other", title: t("machine_other_long") },
          `${t("machine_other")} `,
          button(t("machine_other_show"), this.other),
        ),
      this.shown_file !== 0 &&
        button(t("back_to_program"), () => {
          this.show_file(0, "");
        }),
      app.opened && !app.opened.editable && h("span", { class: "note" }, t("read_only")),
      app.opened?.editable &&
        !this.shows_machine &&
        button(t("save"), () => void save(app), {
          disabled: !app.dirty || !app.hello?.may_change,
          title: app.hello?.may_change ? "Ctrl+S" : t("may_not_change"),
        }),
      this.editing?.save_as &&
        app.opened?.editable &&
        !this.shows_machine &&
        button(t("save_under"), () => this.editing?.save_as?.(), {
          disabled: !app.hello?.may_change,
          title: "Ctrl+Shift+S",
        }),
    );
  }
}

/// The variables that this line names or has changed, with their values.
function beside(s: State): string {
  const text = s.text ?? "";
  const named = (name: string): boolean =>
    new RegExp(`${name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}(?!\\d)`).test(text);
  return (s.variables ?? [])
    .filter((v) => v.changed || named(v.name))
    .slice(0, 6)
    .map((v) => `${v.name} = ${typeof v.value === "number" ? Number(v.value.toPrecision(7)) : (v.value ?? "–")}`)
    .join("  ");
}
