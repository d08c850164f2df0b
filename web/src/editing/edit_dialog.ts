// "Edit program": a form for each edit; the new text next to the old one, with what was proved; nothing changes until
// it is taken over into the editor.
import { MergeView } from "@codemirror/merge";
import { EditorState } from "@codemirror/state";
import { EditorView, lineNumbers } from "@codemirror/view";
import type { App } from "../model/app";
import { debounce } from "../model/latest";
import { LongQuestion } from "../model/long_question";
import { remember, remembered } from "../model/memory";
import type { Socket } from "../protocol/client";
import type { EditedProgram } from "../protocol/types";
import { gcode } from "../source/gcode";
import { phrases_now } from "../source/phrases";
import { t, type TextKey } from "../texts/texts";
import { open_dialog } from "../ui/dialog";
import { button, fill, h, option } from "../ui/dom";
import { toast } from "../ui/toast";
import { BlocksDialog } from "./blocks_dialog";
import { field_row, tools_of } from "./edit_fields";
import {
  edit_question,
  edits,
  words_of,
  wrong_field,
  type EditField,
  type EditName,
  type EditValues,
} from "./edit_form";

const pause = 300; // ms after the last key before the program is edited again

export interface EditVerbs {
  /// Puts a text into the editor, as one change.
  take(text: string): void;
  /// The first and the last line that are selected in the editor.
  selected(): { from: number; to: number } | null;
  /// Shows a line of the program.
  line(line: number): void;
  /// Puts lines after the line of the cursor.
  insert(lines: string[]): void;
  /// Removes the path of the edited program from the view.
  end_paths(): void;
}

export class EditDialog {
  private dialog: HTMLDialogElement;
  private edit: EditName;
  private values: Partial<Record<EditName, EditValues>> = remembered("edit_values", {});
  private asking: LongQuestion<"edit_program">;
  private fields = h("form", {
    class: "edit-fields",
    novalidate: true,
    onsubmit: (e: Event) => e.preventDefault(),
  });
  private told = h("div", { class: "edit-told", role: "status", "aria-live": "polite" });
  private verbs_row = h("div", { class: "row" });
  private host = h("div", { class: "merge" });
  private merge: MergeView | null = null;
  private soon = debounce(pause, () => this.ask());

  constructor(
    private app: App,
    make: () => Socket,
    private verbs: EditVerbs,
  ) {
    const last = remembered<EditName>("edit_name", "feed");
    this.edit = last in edits ? last : "feed";
    this.asking = new LongQuestion(make, "edit_program");
    this.asking.on_change.on(() => this.draw_answer());
    const here = app.opened!.file;
    const off = [
      app.on_opening.on((file) => {
        if (file !== here) this.dialog.close();
      }),
      app.on_text.on(() => this.soon()),
    ];
    const which = h(
      "select",
      { name: "edit", "aria-label": t("edit_what"), onchange: () => this.choose(which.value as EditName) },
      ...(Object.keys(edits) as EditName[]).map((name) => option(name, t(`edit_${name}`), name === this.edit)),
    );
    this.dialog = open_dialog(
      `${t("edit_program")}: ${here}`,
      h(
        "div",
        { class: "edit" },
        h("label", { class: "edit-row" }, h("span", null, t("edit_what")), which),
        this.fields,
        this.told,
        this.verbs_row,
        this.host,
      ),
      {
        docked: "left",
        tools: button(t("blocks_title"), () => new BlocksDialog(this.app, this.verbs)),
        closed: () => {
          for (const f of off) f();
          this.asking.close();
          this.merge?.destroy();
          verbs.end_paths();
        },
      },
    );
    this.take_selection();
    this.draw();
    this.draw_answer();
    this.ask();
    which.focus();
  }

  private get own(): EditValues {
    return (this.values[this.edit] ??= {});
  }

  private choose(edit: EditName): void {
    this.edit = edit;
    remember("edit_name", edit);
    this.take_selection();
    this.draw();
    this.ask();
  }

  /// A contour is reversed in the lines that are selected now.
  private take_selection(): void {
    const lines = this.edit === "reverse" ? this.verbs.selected() : null;
    if (lines) this.values.reverse = { from: String(lines.from), to: String(lines.to) };
  }

  private set(field: EditField, value: string): void {
    this.own[field.name] = value;
    remember("edit_values", this.values);
    this.mark_wrong();
    this.soon();
  }

  private ask(): void {
    if (this.dialog.open) this.asking.want(edit_question(this.app, words_of(this.edit, this.own)));
  }

  private draw(): void {
    const tools = tools_of(this.app.done?.tools ?? []);
    fill(
      this.fields,
      ...edits[this.edit].map((f) => field_row(f, this.own[f.name] ?? f.usual, tools, (value) => this.set(f, value))),
      is_noted(this.edit) && h("p", { class: "note" }, t(`edit_${this.edit}_note`)),
    );
    this.mark_wrong();
  }

  private mark_wrong(): void {
    const wrong = wrong_field(this.edit, this.own);
    for (const input of this.fields.querySelectorAll("input"))
      input.setAttribute("aria-invalid", String(input.name === wrong));
  }

  private draw_answer(): void {
    const { asking } = this,
      answer = asking.busy ? null : asking.answer;
    fill(this.told, ...this.sentences(answer));
    const taken = answer !== null && answer.text !== "" && answer.lines > 0;
    fill(
      this.verbs_row,
      button(t("edit_take"), () => this.take(), {
        class: "main",
        disabled: !taken || !this.app.opened?.editable,
        title: t("edit_take_long"),
      }),
      button(t("edit_paths"), () => void this.show_paths(), { disabled: !taken }),
    );
    this.draw_texts(taken ? answer.text : null);
  }

  private sentences(answer: EditedProgram | null): HTMLElement[] {
    const { asking, app } = this;
    const line = (text: string, kind: string): HTMLElement => h("p", { class: kind }, text);
    if (app.text === null) return [line(t("edit_no_text"), "hint error")];
    if (asking.busy) return [line(t("edit_working"), "note")];
    if (asking.refusal) return [line(asking.refusal, "hint error")];
    if (!answer) return [line(t("edit_fill_in"), "note")];
    if (answer.refused.length)
      return [
        line(t("edit_refused"), "hint error"),
        h("ul", { class: "edit-refused" }, ...answer.refused.map((one) => this.reason(one))),
      ];
    return [
      line(answer.lines ? t("edit_changed", { count: answer.lines }) : t("edit_nothing"), ""),
      line(answer.told, "good"),
      ...(answer.note ? [line(answer.note, "mill-warning")] : []),
    ];
  }

  private reason(one: EditedProgram["refused"][number]): HTMLElement {
    return h(
      "li",
      null,
      one.line > 0 && button(t("line_n", { line: one.line }), () => this.verbs.line(one.line), { class: "link" }),
      ` ${one.text}`,
    );
  }

  private draw_texts(made: string | null): void {
    this.merge?.destroy();
    this.merge = null;
    this.host.hidden = made === null;
    if (made === null) return;
    this.merge = new MergeView({
      a: side(this.app.text ?? "", "edit_before"),
      b: side(made, "edit_after"),
      parent: this.host,
      collapseUnchanged: { margin: 2, minSize: 6 },
    });
  }

  private take(): void {
    const made = this.asking.answer?.text;
    if (!made) return;
    this.dialog.close();
    this.verbs.take(made);
    toast(t("edit_taken"));
  }

  /// The path of the edited program next to that of the program, in the view.
  private async show_paths(): Promise<void> {
    const made = this.asking.answer?.text;
    if (!made || !(await this.app.run_shown())) return;
    this.verbs.end_paths();
    try {
      await this.app.client.ask("compare", { text: made });
    } catch (e) {
      this.app.tell(e);
    }
  }
}

const is_noted = (edit: EditName): edit is "mirror" | "copy" | "copy_around" | "reverse" =>
  edit === "mirror" || edit === "copy" || edit === "copy_around" || edit === "reverse";

const side = (doc: string, name: TextKey) => ({
  doc,
  extensions: [
    lineNumbers(),
    gcode,
    phrases_now(),
    EditorState.readOnly.of(true),
    EditorView.editable.of(false),
    EditorView.contentAttributes.of({ "aria-label": t(name) }),
  ],
});
