// The structure of the program, next to its text: programs, tools, cycles, labels. Only the rows in view are drawn.
import { StateEffect } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import type { App } from "../model/app";
import { debounce, Latest } from "../model/latest";
import { remember, remembered } from "../model/memory";
import { OutlineTree } from "../model/outline_tree";
import type { OutlineEntry, OutlineKind } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { fill, h } from "../ui/dom";
import { icon, type IconName } from "../ui/icons";
import type { SourcePane } from "./pane";

const quiet = 300, // ms without a key before the text is read again
  longest = 2000; // ms: while somebody types without a pause
const wide = 640; // px of the text and the structure next to each other
const least_entries = 2; // one entry alone is no structure
const icons: Record<OutlineKind, IconName> = {
  program: "program",
  subprogram: "program",
  tool: "tools",
  cycle: "cycle",
  label: "label",
  section: "section",
};

export class OutlinePane {
  readonly element = h("section", { class: "outline", hidden: true });
  private head = h("button", { type: "button", class: "outline-head", onclick: () => this.fold(!this.open) });
  private space = h("div", { class: "outline-space" });
  private rows = h("div", { class: "outline-rows" });
  private list = h("div", { class: "outline-list", role: "tree", tabindex: "0" }, this.space, this.rows);
  private tree = new OutlineTree();
  private open = remembered("outline_open", window.innerHeight >= 700);
  private chosen = 0; // the entry that the keys move
  private line = 0; // of the cursor
  private running = 0; // the line that the slider shows
  private more = false;
  private ask = new Latest<string | null>((text) => this.take(text));
  private ask_soon = debounce(quiet, () => this.ask.want(this.app.text), longest);

  constructor(
    private app: App,
    private source: SourcePane,
  ) {
    this.element.append(this.head, this.list);
    app.on_opening.on((file) => {
      if (file !== app.opened?.file) this.show([], false);
    });
    app.on_opened.on(() => this.ask.want(app.text));
    app.on_text.on(() => this.ask_soon());
    app.on_state.on((s) => {
      const before = this.tree.at_line(this.running);
      this.running = s && !s.file ? s.line : 0;
      if (this.tree.at_line(this.running) !== before) this.draw(); // not at each line of a tool
    });
    source.on_cursor.on((line) => this.at(line));
    source.on_view.on((view) => {
      if (view?.editor) follow_cursor(view.editor, (line) => this.at(line));
    });
    this.list.addEventListener("scroll", () => this.draw());
    this.list.addEventListener("keydown", (e) => this.key(e));
    this.list.addEventListener("click", (e) => this.click(e as PointerEvent));
    new ResizeObserver(() => this.draw()).observe(this.list);
    new ResizeObserver(() => this.place()).observe(source.body);
    source.body.append(this.element);
    on_language(() => this.name());
    this.name();
  }

  private async take(text: string | null): Promise<void> {
    const { entries, more } = await this.app.client.ask("outline", text === null ? {} : { text });
    if (this.app.opened) this.show(entries, more);
  }
  private show(entries: OutlineEntry[], more: boolean): void {
    this.more = more;
    this.tree.set(entries);
    this.chosen = Math.min(this.chosen, Math.max(0, entries.length - 1));
    this.element.hidden = entries.length < least_entries;
    this.name();
  }
  private name(): void {
    this.list.setAttribute("aria-label", t("outline"));
    this.head.setAttribute("aria-expanded", String(this.open));
    this.element.classList.toggle("closed", !this.open);
    this.list.hidden = !this.open;
    this.place();
    fill(
      this.head,
      h("span", { class: "outline-arrow" }, icon("more")),
      t("outline"),
      this.more && h("span", { class: "note" }, t("outline_more", { count: this.tree.entries.length })),
    );
    this.draw();
  }
  private fold(open: boolean): void {
    this.open = open;
    remember("outline_open", open);
    this.name();
    const entry = this.tree.at_line(this.line);
    if (open && entry >= 0) this.choose(entry);
  }

  /// In a wide pane it is next to the text, else below it.
  private place(): void {
    const { body } = this.source;
    body.classList.toggle("beside", this.open && !this.element.hidden && body.clientWidth >= wide);
  }

  /// The cursor is in another line.
  private at(line: number): void {
    const before = this.tree.at_line(this.line),
      entry = this.tree.at_line(line);
    this.line = line;
    if (entry >= 0 && entry !== before && document.activeElement !== this.list) this.choose(entry);
    else if (entry !== before) this.draw();
  }
  private choose(entry: number): void {
    this.chosen = entry;
    const row = this.tree.shown.indexOf(entry),
      height = this.row_height(),
      { scrollTop, clientHeight } = this.list;
    if (row * height < scrollTop) this.list.scrollTop = row * height;
    else if ((row + 1) * height > scrollTop + clientHeight) this.list.scrollTop = (row + 1) * height - clientHeight;
    this.draw();
  }
  private go(entry: number, focus: boolean): void {
    const line = this.tree.entries[entry]?.line;
    if (line) this.source.go_to(line, focus);
  }

  private key(e: KeyboardEvent): void {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    const page = Math.max(1, Math.floor(this.list.clientHeight / this.row_height()) - 1),
      to = this.tree.press(e.key, this.chosen, page);
    if (to === null && e.key !== "Enter" && e.key !== " ") return;
    e.preventDefault();
    e.stopPropagation();
    if (to === null) this.go(this.chosen, e.key === "Enter");
    else this.choose(to);
  }
  private click(e: PointerEvent): void {
    const row = (e.target as Element).closest<HTMLElement>(".outline-row");
    if (!row) return;
    const entry = Number(row.dataset.entry);
    if ((e.target as Element).closest(".outline-arrow")) {
      this.tree.toggle(entry);
      return this.choose(entry);
    }
    this.choose(entry);
    this.go(entry, e.pointerType !== "touch"); // the focus would open the keyboard of the screen
  }

  private row_height(): number {
    return (parseFloat(getComputedStyle(this.list).getPropertyValue("--row")) || 19) + 2; // outline.css
  }
  private draw(): void {
    if (this.list.hidden || this.element.hidden) return;
    const height = this.row_height(),
      { shown } = this.tree,
      first = Math.max(0, Math.floor(this.list.scrollTop / height)),
      count = Math.min(shown.length - first, Math.ceil((this.list.clientHeight || 400) / height) + 1),
      here = this.tree.at_line(this.line),
      runs = this.tree.at_line(this.running);
    this.space.style.height = `${shown.length * height}px`;
    this.rows.style.transform = `translateY(${first * height}px)`;
    while (this.rows.childElementCount > Math.max(0, count)) this.rows.lastElementChild!.remove();
    for (let i = 0; i < count; i++) {
      const row = this.rows.children[i] ?? this.rows.appendChild(h("div", { class: "outline-row", role: "treeitem" }));
      this.draw_row(row as HTMLElement, shown[first + i]!, here, runs);
    }
    this.list.setAttribute("aria-activedescendant", `outline-${this.chosen}`);
  }
  private draw_row(row: HTMLElement, i: number, here: number, runs: number): void {
    const entry = this.tree.entries[i]!,
      { place, count } = this.tree.among(i),
      inside = this.tree.has_inside(i);
    row.id = `outline-${i}`;
    row.dataset.entry = String(i);
    row.dataset.kind = entry.kind;
    row.title = `${entry.name}${entry.title ? ` – ${entry.title}` : ""}\n${t("line")} ${entry.line}`;
    row.style.setProperty("--depth", String(entry.depth));
    row.setAttribute("aria-level", String(entry.depth + 1));
    row.setAttribute("aria-posinset", String(place));
    row.setAttribute("aria-setsize", String(count));
    row.setAttribute("aria-selected", String(i === this.chosen));
    if (inside) row.setAttribute("aria-expanded", String(this.tree.is_open(i)));
    else row.removeAttribute("aria-expanded");
    if (i === here) row.setAttribute("aria-current", "location");
    else row.removeAttribute("aria-current");
    row.classList.toggle("runs", i === runs);
    fill(
      row,
      h("span", { class: "outline-arrow" }, inside && icon("more")),
      icon(icons[entry.kind]),
      h(
        "span",
        { class: "outline-name" },
        entry.name,
        entry.title && h("span", { class: "outline-title" }, ` ${entry.title}`),
      ),
      h("span", { class: "outline-line" }, entry.line),
    );
  }
}

/// Reports the line of the cursor whenever it moves, by keys, the mouse or typing.
function follow_cursor(editor: EditorView, take: (line: number) => void): void {
  const listener = EditorView.updateListener.of((u) => {
    if (u.docChanged || u.selectionSet) take(u.state.doc.lineAt(u.state.selection.main.head).number);
  });
  editor.dispatch({ effects: StateEffect.appendConfig.of(listener) });
}
