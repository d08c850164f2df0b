// A new program from a drawing: a form on the left, the result on the right, computed again after each change.
import type { App } from "../model/app";
import { debounce } from "../model/latest";
import { Making } from "../model/making";
import { remember, remembered } from "../model/memory";
import { question_of, type Field, type MillForm } from "../model/mill_form";
import { files_beneath, save_new } from "../model/new_file";
import type { Socket } from "../protocol/client";
import { t } from "../texts/texts";
import { open_dialog } from "./dialog";
import { button, h } from "./dom";
import { MillAnswer } from "./mill_answer";
import { MillFields } from "./mill_fields";
import { may_leave, may_replace } from "./save";
import { toast } from "./toast";

const is_drawing = (name: string): boolean => /\.(dxf|svg|txt)$/i.test(name);
const pause = 350; // ms after the last key before it is computed again

export class MakingDialog {
  private making: Making;
  private dialog: HTMLDialogElement;
  private form: MillForm;
  private fields: MillFields;
  private result = new MillAnswer();
  private name = h("input", {
    "aria-label": t("file_name"),
    size: "24",
    oninput: () => {
      this.name_typed = this.name.value !== "";
    },
    onkeydown: (e: KeyboardEvent) => {
      if (e.key === "Enter" && !this.save.disabled) void this.keep();
    },
  });
  private save = button(t("save_and_open"), () => void this.keep(), { class: "main", disabled: true });
  private fault = h("p", { class: "hint error", role: "alert" }); // of saving
  private name_typed = false;
  private drawings: string[] | null = null;
  private soon = debounce(pause, () => {
    if (this.dialog.open) this.ask_for_it();
  });

  /// `drawing`: the initial choice; `folder`: its drawings are listed first.
  constructor(
    private app: App,
    make: () => Socket,
    folder: string,
    drawing = "",
  ) {
    const control =
      app.opened?.control.id ?? remembered("making", {} as MillForm).control ?? app.hello?.controls[0]?.id ?? "";
    this.form = { task: "pocket", ...remembered("making", {} as MillForm), drawing, control };
    this.fields = new MillFields(app, this.form, {
      set: (field, value, draws) => this.set(field, value, draws),
      preview: () => this.ask_for_it(true),
    });
    this.making = new Making(make);
    this.making.on_change.on(() => this.draw_answer());
    this.dialog = open_dialog(
      t("new_from_drawing"),
      h(
        "div",
        { class: "mill" },
        this.fields.element,
        h(
          "div",
          { class: "mill-result" },
          this.result.told,
          this.result.picture,
          this.result.summary,
          h(
            "div",
            { class: "row" },
            h("label", { class: "field" }, h("span", null, t("save_as")), this.name),
            this.save,
          ),
          this.fault,
        ),
      ),
      {
        wide: true,
        closed: () => {
          this.making.close();
          this.result.close();
        },
      },
    );
    this.fields.draw(this.drawings);
    this.draw_answer();
    void this.list(folder);
  }

  private async list(folder: string): Promise<void> {
    try {
      this.drawings = await files_beneath(this.app, folder, is_drawing);
    } catch (e) {
      this.app.tell(e);
      this.drawings = [];
    }
    this.form.drawing ||= this.drawings.find((d) => d === remembered("making_drawing", "", "tab")) ?? "";
    this.fields.draw(this.drawings);
    this.fields.focus("drawing");
    this.ask_for_it();
  }

  private set(field: Field, value: string, draws: boolean): void {
    this.form[field] = value;
    if (field === "drawing") {
      this.name_typed = false;
      remember("making_drawing", value, "tab");
    }
    const { drawing: _, ...kept } = this.form;
    remember("making", kept);
    if (draws) this.fields.draw(this.drawings);
    this.soon();
  }

  private ask_for_it(again = false): void {
    const made = question_of(this.form);
    this.making.want("question" in made ? made.question : null, again);
    this.fields.mark("wrong" in made ? made.wrong : []);
  }

  private draw_answer(): void {
    const { making, result } = this,
      a = making.answer,
      made = question_of(this.form),
      may = Boolean(this.app.hello?.may_change);
    this.save.disabled = !making.program || !may;
    this.save.title = may ? "" : t("may_not_change");
    this.dialog.classList.toggle("making", making.busy);
    if (!("question" in made)) return result.show_incomplete(made.wrong, made.missing);
    if (making.busy) return result.show_busy();
    if (making.refusal) return result.show_refusal(making.refusal);
    if (a && "problem" in a) {
      this.fields.mark([a.word]);
      return result.show_problem(a, this.form.drawing ?? "");
    }
    result.show(a);
    if (a && !this.name_typed) this.name.value = a.name;
  }

  private async keep(): Promise<void> {
    const program = this.making.program,
      file = this.name.value.trim(),
      control = this.form.control;
    if (!program || !file) return this.name.focus();
    const fault = await save_new(this.app, file, { text: program.text }, () => may_replace(file));
    this.fault.textContent = fault;
    if (fault) return this.name.select();
    toast(t("saved", { file }));
    this.app.on_files.emit(file);
    if (!(await may_leave(this.app))) return;
    this.dialog.close();
    await this.app.open({ file, control });
  }
}
