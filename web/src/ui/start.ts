// What the page shows while no program is open: the examples, one click each, and other ways to begin.
import type { App } from "../model/app";
import type { Example } from "../protocol/types";
import { alone } from "../protocol/way";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { icon } from "./icons";

export interface StartVerbs {
  new_program(): void;
  upload(): void;
  tour(): void;
}

export class Start {
  readonly element = h("div", { class: "start" });
  private examples: Example[] = [];

  constructor(
    private app: App,
    private verbs: StartVerbs,
  ) {
    app.on_line.on((line) => {
      if (line === "open") void this.ask();
    });
    for (const s of [app.on_opening, app.on_opened, app.on_run]) s.on(() => this.draw());
    on_language(() => void this.ask());
    this.draw();
  }

  private async ask(): Promise<void> {
    try {
      this.examples = (await this.app.client.ask("examples", {})).examples;
    } catch {
      this.examples = []; // the connection is not open
    }
    this.draw();
  }

  private draw(): void {
    const { app, verbs } = this,
      hidden = app.opened !== null || app.running;
    if (hidden && this.element.hidden) return;
    this.element.hidden = hidden;
    if (hidden) return;
    const may = { disabled: !app.hello?.may_change, title: app.hello?.may_change ? "" : t("may_not_change") };
    fill(
      this.element,
      h("h2", null, t("start_title")),
      h("p", null, t(alone ? "alone_start" : "start_open")),
      alone && h("p", { class: "note" }, alone.told()),
      h(
        "div",
        { class: "row" },
        button(t("tour"), verbs.tour, { class: "main" }),
        button(t("new_program"), verbs.new_program, may),
        button(t(alone ? "alone_open" : "upload"), verbs.upload, may),
      ),
      this.examples.length > 0 && h("h3", null, t("start_examples")),
      h("ul", { class: "examples" }, ...this.examples.map((e) => this.row(e, may))),
      this.examples.length > 0 && h("p", { class: "note" }, t("start_copied")),
    );
  }

  private row(example: Example, may: Record<string, unknown>): HTMLElement {
    const control = this.app.hello?.controls.find((c) => c.id === example.control)?.name ?? example.control;
    return h(
      "li",
      null,
      h(
        "button",
        { type: "button", "data-example": example.name, onclick: () => void this.take(example), ...may },
        icon("program"),
        h("span", null, example.title),
        h("span", { class: "dim" }, control),
      ),
    );
  }

  private async take(example: Example): Promise<void> {
    const { app } = this;
    try {
      const { file, control, machine, setup } = await app.client.ask("take_example", { name: example.name });
      await app.open({ file, control, machine, setup });
    } catch (e) {
      app.tell(e);
    }
  }
}
