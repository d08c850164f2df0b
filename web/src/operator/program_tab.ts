// The tab of the program: its path, its text, or the files to choose another one.
import type { App } from "../model/app";
import { remember, remembered } from "../model/memory";
import { on_language, t } from "../texts/texts";
import { button, h } from "../ui/dom";
import { Borrowed } from "./parts";

const views = ["op_path", "op_text", "op_files"] as const;
type View = (typeof views)[number];

export class ProgramTab {
  readonly element = h("div", { class: "program-tab" });
  private bar = h("div", { class: "switch", role: "group" });
  private keys: HTMLButtonElement[];
  private host = h("div", { class: "program-host" });
  private borrowed: Record<View, Borrowed>;
  private view: View = remembered<View>("op_view", "op_path");
  private is_open = false;
  private leaves = false; // the files are left when a program is opened
  private files_were_hidden = false;

  constructor(
    private scene: HTMLElement,
    private source: HTMLElement,
    private files: HTMLElement,
    app: App,
  ) {
    this.borrowed = {
      op_path: new Borrowed(scene),
      op_text: new Borrowed(source),
      op_files: new Borrowed(files),
    };
    this.keys = views.map((v) => button("", () => this.choose(v), { "aria-pressed": false }));
    this.bar.append(...this.keys);
    this.element.append(this.bar, this.host);
    this.host.addEventListener("click", (e) => {
      if (e.target instanceof Element && e.target.closest(".file-row")) this.leaves = true;
      else if (this.view === "op_files") this.leaves = false;
    });
    app.on_opened.on(() => {
      if (this.view === "op_files" && this.leaves) this.choose(remembered<View>("op_view", "op_path"));
    });
    on_language(() => this.draw());
    this.draw();
  }

  /// Without a program the files are what is needed.
  show_files(until_opened = false): void {
    this.leaves = until_opened;
    this.choose("op_files");
  }
  show_text(): void {
    this.choose("op_text");
  }

  open(): void {
    this.is_open = true;
    this.files_were_hidden = this.files.hidden;
    for (const b of Object.values(this.borrowed)) b.take(this.host);
    this.draw();
  }
  close(): void {
    this.is_open = false;
    for (const b of Object.values(this.borrowed)) b.give_back();
    for (const e of [this.scene, this.source]) e.hidden = false;
    this.files.hidden = this.files_were_hidden;
  }

  private choose(view: View): void {
    this.view = view;
    if (view !== "op_files") this.leaves = false;
    if (view !== "op_files") remember("op_view", view);
    this.draw();
    if (this.is_open) dispatchEvent(new Event("resize"));
  }

  private draw(): void {
    this.bar.setAttribute("aria-label", t("op_program"));
    for (const [i, key] of this.keys.entries()) {
      key.textContent = t(views[i]!);
      key.setAttribute("aria-pressed", String(views[i] === this.view));
    }
    if (!this.is_open) return;
    this.scene.hidden = this.view !== "op_path";
    this.source.hidden = this.view !== "op_text";
    this.files.hidden = this.view !== "op_files";
  }
}
