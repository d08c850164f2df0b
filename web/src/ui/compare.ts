// Two versions of a program: their texts side by side, their paths overlaid in the view.
import { MergeView } from "@codemirror/merge";
import { EditorState } from "@codemirror/state";
import { EditorView, lineNumbers } from "@codemirror/view";
import type { App } from "../model/app";
import type { Difference } from "../protocol/types";
import { gcode } from "../source/gcode";
import { phrases_now } from "../source/phrases";
import { t } from "../texts/texts";
import { open_dialog } from "./dialog";
import { button, fill, h } from "./dom";

export interface CompareVerbs {
  begin(): void;
  line(line: number): void;
}

/// `begin`: removes the other path from the view; `line`: a line of this program was clicked. `given`: another text of
/// this program, which is compared at once.
export function show_compare(app: App, verbs: CompareVerbs, given?: { name: string; text: string }): void {
  if (document.querySelector("dialog.docked .compare")) return;
  const file = h("select", { "aria-label": t("other_version") }),
    told = h("p", { class: "note", "aria-live": "polite" }),
    stale = h("p", { class: "hint stale", "aria-live": "polite", hidden: true }, t("compare_again")),
    list = h("ol", { class: "differences" }),
    host = h("div", { class: "merge" });
  let merge: MergeView | null = null,
    compared: string | null | undefined; // undefined: nothing has been compared
  const tell_changes = (): void => {
    stale.hidden = compared === undefined || compared === app.text;
  };
  const here = app.opened!.file,
    folder = here.includes("/") ? here.slice(0, here.lastIndexOf("/")) : "";
  const go = async (): Promise<void> => {
    if (!file.value) return;
    const wanted = file.value,
      shown = app.text,
      saved = app.saved_text;
    verbs.begin();
    told.textContent = t("comparing");
    list.replaceChildren();
    compared = undefined;
    try {
      if (!(await app.run_shown())) return void (told.textContent = "");
      const text = wanted === of_given ? given?.text : wanted === here ? (saved ?? "") : undefined,
        c = await app.client.ask("compare", text === undefined ? { file: wanted } : { text });
      told.textContent = c.text;
      compared = shown;
      tell_changes();
      list.replaceChildren(
        ...c.differences.map((d) =>
          h(
            "li",
            null,
            button(difference_text(d), () => {
              app.seek_block(d.a.number);
              verbs.line(d.a.line);
            }),
          ),
        ),
      );
    } catch (e) {
      told.textContent = "";
      app.tell(e);
    }
    merge?.destroy();
    const other = wanted === of_given ? (given?.text ?? null) : wanted === here ? saved : await text_of(app, wanted);
    if (other === null || shown === null) told.textContent += ` ${t("no_text_here")}`;
    else
      merge = new MergeView({
        a: side(other),
        b: side(shown, (n) => verbs.line(n)),
        parent: host,
        collapseUnchanged: { margin: 3, minSize: 8 },
      });
  };
  const fill_select = (): Promise<void> => fill_files(app, folder, here, file, given?.name);
  const off = [app.on_text.on(tell_changes), app.on_dirty.on(() => void fill_select())];
  open_dialog(
    t("compare"),
    h(
      "div",
      { class: "compare" },
      h(
        "div",
        { class: "row" },
        h("label", { class: "field" }, h("span", null, t("other_version")), file),
        button(t("compare"), () => void go(), { class: "main" }),
        told,
      ),
      stale,
      list,
      host,
    ),
    {
      docked: "left",
      closed: () => {
        for (const f of off) f();
        merge?.destroy();
        verbs.begin();
      },
    },
  );
  void fill_select().then(() => {
    if (given) void go();
  });
}

const side = (doc: string, clicked?: (line: number) => void) => ({
  doc,
  extensions: [
    EditorView.updateListener.of((u) => {
      if (u.selectionSet) clicked?.(u.state.doc.lineAt(u.state.selection.main.head).number);
    }),
    lineNumbers(),
    gcode,
    phrases_now(),
    EditorState.readOnly.of(true),
    EditorView.editable.of(false),
  ],
});

const of_given = "/"; // no name of a file

async function fill_files(
  app: App,
  folder: string,
  here: string,
  select: HTMLSelectElement,
  given?: string,
): Promise<void> {
  const chosen = select.value;
  try {
    const { entries } = await app.client.ask("files", { folder });
    const names = entries
      .filter((e) => e.kind === "program")
      .map((e) => (folder ? `${folder}/${e.name}` : e.name))
      .filter((n) => n !== here);
    fill(
      select,
      given && h("option", { value: of_given }, given),
      app.dirty && h("option", { value: here }, t("as_saved", { file: here })),
      ...names.map((n) => h("option", { value: n }, n)),
    );
    if ([...select.options].some((o) => o.value === chosen)) select.value = chosen;
  } catch (e) {
    app.tell(e);
  }
}

/// Returns null if it cannot be shown here.
async function text_of(app: App, file: string): Promise<string | null> {
  try {
    return (await app.client.ask("read", { file })).text;
  } catch (e) {
    app.tell(e);
    return null;
  }
}

/// "12 – 15 | 12 – 14: feed: F100 mm/min — F200 mm/min"; the first lines are those of the open program.
export function difference_text(d: Difference): string {
  const lines = (s: { line: number; to_line: number }): string =>
    s.to_line > s.line ? `${s.line} – ${s.to_line}` : `${s.line}`;
  return `${lines(d.a)} | ${lines(d.b)}: ${d.text}`;
}
