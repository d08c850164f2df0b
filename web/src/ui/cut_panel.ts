// Cutting: blank and tools as proposed, which can be changed; then the progress, the collisions, and the remaining
// stock.
import type { App } from "../model/app";
import { extent_of } from "../model/stock";
import { new_tool } from "../model/tool_shape";
import { Refused } from "../protocol/client";
import type { BlankSource, Box, Insert, KeptFile, PartAnswer, Problem, Tool } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { CutProblems } from "./problems_panel";
import { fixtures_form, stock_form } from "./stock_form";
import { cut_facts } from "./cut_facts";
import { toast } from "./toast";
import { files_form, text_input, tool_form } from "./tool_form";

export class CutPanel {
  readonly element = h("div", { class: "cut" });
  private stock = "";
  private by: BlankSource | null = null; // what states the blank
  private keep: KeptFile | null = null; // the tools file of the program
  private tools: Tool[] = [];
  private files: string[] = []; // tools files next to the program
  private fixtures: string[] = [];
  private resolution = "";
  private inserts: Insert[] = []; // outlines of the turning tools as proposed, or as cut
  private known = false;
  private of: string | null = null; // the program that blank and tools belong to
  private touched = false; // by the user
  private proposing = 0; // questions for the proposals in progress
  private cuts_next = false; // as soon as the proposals of the shown text are here
  private run_row = h("div", { class: "cut-run" });
  private run_shown = ""; // state of the button in it
  private choices = h("div", { class: "row cut-choices" });
  private form = h("div");
  private told = h("div", { "aria-live": "polite" });
  private part: PartAnswer | null = null;
  private refusal = ""; // why the last cut was refused
  private hit: CutProblems;

  constructor(
    private app: App,
    private shown: (stock: Box | null, tools: Tool[], inserts: Insert[]) => void,
    jump: (p: Problem) => void,
  ) {
    this.hit = new CutProblems(app, jump);
    this.element.append(h("div", { class: "row cut-start" }, this.run_row, this.choices), this.told, this.form);
    this.element.addEventListener("change", () => {
      this.touched = true;
    });
    app.on_opening.on((file) => {
      if (file !== this.of) this.cuts_next = false;
      this.refusal = "";
      this.known = false;
      this.part = null;
      this.draw();
    });
    app.on_done.on(() => void this.propose().then(() => this.cut_proposed()));
    app.on_cut.on((part) => {
      if (part === null) this.part = app.cut_ready ? this.part : null;
      this.draw_told(part);
      if (part === null || part === 0) this.draw_run();
      if (part === null && app.cut?.inserts?.length) {
        this.inserts = app.cut.inserts;
        this.show();
      }
    });
    app.on_part_told.on((p) => {
      this.part = p;
      this.draw_told(null);
    });
    on_language(() => this.draw());
    this.draw();
  }

  badge(): string {
    return this.hit.badge();
  }

  private async propose(): Promise<void> {
    this.proposing++;
    try {
      const p = await this.app.client.ask("proposals", {});
      const opened = this.app.opened?.file ?? null;
      if (opened === null || opened !== this.of || !this.touched) {
        // changes by the user stay while the program is edited
        this.touched = false;
        this.stock = p.stock ?? "";
        this.by = p.stock_by ?? null;
        this.tools = p.tools ?? [];
        this.fixtures = p.fixtures ?? [];
        this.resolution = "";
      } else this.tools.push(...(p.tools ?? []).filter((x) => !this.tools.some((y) => y.number === x.number)));
      this.of = opened;
      this.files = p.files ?? [];
      this.keep = p.keep ?? null;
      this.inserts = p.inserts ?? [];
      this.known = true;
    } catch {
      this.known = true; /* a program without motion has no blank: the form stays empty */
    }
    this.proposing--;
    this.draw();
  }

  /// Reads the tools from a file next to the program.
  private async take_file(file: string): Promise<void> {
    try {
      const found = await this.app.client.ask("proposals", { tools: file });
      this.tools = found.tools;
      this.inserts = found.inserts ?? [];
    } catch (e) {
      this.app.tell(e);
    }
    this.draw();
  }

  private draw(): void {
    if (!this.known) fill(this.form, h("p", { class: "note" }, this.app.opened ? t("running") : t("open_a_program")));
    else
      fill(
        this.form,
        h("h3", null, `${t("stock")}, ${t("mm")}`),
        stock_form(this.stock, this.by, (stock) => {
          this.stock = stock;
          this.by = null;
          this.draw();
        }),
        fixtures_form(this.fixtures, (fixtures) => {
          this.fixtures = fixtures;
          this.draw();
        }),
        h("h3", null, `${t("tools")}, ${t("mm")}`),
        this.files.length > 0 && files_form(this.files, (file) => void this.take_file(file)),
        !this.tools.length && h("p", { class: "note" }, t("tools_none")),
        ...this.tools.map((x) =>
          tool_form(x, this.inserts, () => {
            this.inserts = this.inserts.filter((i) => i.tool !== x.number);
            this.draw();
          }),
        ),
        button(t("add_tool"), () => {
          this.touched = true;
          this.tools.push(new_tool(this.tools, this.app.done?.tools.map((x) => x.tool) ?? []));
          this.draw();
        }),
      );
    fill(
      this.choices,
      this.known &&
        h(
          "label",
          { class: "field" },
          h("span", null, t("resolution")),
          text_input(
            this.resolution,
            (v) => {
              this.resolution = v;
            },
            { placeholder: t("auto"), inputmode: "decimal" },
          ),
          h("span", { class: "dim" }, t("mm")),
        ),
    );
    if (this.known && this.app.hello?.may_change && this.keep)
      this.choices.append(button(t("cut_keep"), () => void this.keep_all(), { title: t("cut_keep_long") }));
    this.draw_run();
    this.draw_told(null);
    this.show();
  }

  private show(): void {
    if (this.known) this.shown(extent_of(this.stock), this.tools, this.inserts);
  }

  /// A button that is replaced or disabled while it is pressed hears no click. So it stays while the program runs again
  /// after each change of its text, and a click during a run cuts at the end of the run.
  private draw_run(): void {
    const there = this.known || this.app.opened !== null;
    const shown = there ? `${this.app.cutting} ${t("cut")}` : "";
    if (shown === this.run_shown) return;
    this.run_shown = shown;
    fill(
      this.run_row,
      there &&
        (this.app.cutting
          ? button(t("stop"), () => this.app.stop(), { class: "stop" })
          : button(t("cut"), () => void this.run(), { class: "main" })),
    );
  }

  /// Blank and tools that an older text proposed do not fit: the cut waits for those of the text that is shown.
  private async run(): Promise<void> {
    this.cuts_next = true;
    if (!(await this.app.run_shown())) this.cuts_next = false;
    this.cut_proposed();
  }
  private cut_proposed(): void {
    if (!this.cuts_next || this.proposing || this.app.running) return;
    this.cuts_next = false;
    const r = Number(this.resolution.replace(",", "."));
    const tools = this.tools.map(({ from: _, known: __, ...shape }) => shape);
    this.refusal = "";
    void this.app
      .run_cut({
        stock: this.stock,
        tools,
        ...(this.fixtures.length ? { fixtures: this.fixtures } : {}),
        ...(r > 0 ? { resolution: r } : {}),
      })
      .then((refusal) => refusal && this.tell_refusal(refusal));
  }

  /// What was refused stays on the panel, and the first field that has to be filled in is ready for it.
  private tell_refusal(refusal: string): void {
    this.refusal = refusal;
    this.draw_told(null);
    for (const field of this.form.querySelectorAll<HTMLInputElement>(".tool-form.unknown .fields input"))
      if (field.value === "") return field.focus();
  }

  /// Writes blank and fixtures into the set-up of the program, and the tools into its tools file.
  private async keep_all(): Promise<void> {
    const { app, keep } = this;
    if (!keep) return;
    const tools = this.tools.filter((x) => !x.by_offset).map(({ from: _, known: __, ...shape }) => shape);
    try {
      const form = await app.client.ask("setup_form", {});
      const values = { stock: this.stock || null, fixtures: this.fixtures.length ? this.fixtures : null };
      if (tools.length) keep.digest = (await app.client.ask("keep_tools", { ...keep, tools })).digest;
      await app.client.ask("keep_setup", { file: form.file, digest: form.digest, values });
      toast(t("cut_kept", { setup: form.file, tools: keep.file }));
      app.on_files.emit(form.file);
      if (app.choice.setup !== form.file) await app.run_again({ ...app.choice, setup: form.file });
    } catch (e) {
      app.tell(e instanceof Refused && e.changed ? t("cut_not_kept", { tools: keep.file }) : e);
    }
  }

  private draw_told(part: number | null): void {
    const bar =
      part !== null && this.app.cutting ? h("progress", { max: 1, value: part, "aria-label": t("cutting") }) : null;
    const refused = this.refusal ? h("p", { class: "hint error" }, this.refusal) : null;
    fill(this.told, bar, refused, ...cut_facts(this.app.cut, this.part), ...this.hit.rows());
  }
}
