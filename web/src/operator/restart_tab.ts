// The tab to go on in the middle of the program, with stop points and watches.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { OperatorPanel } from "../ui/operator_panel";
import { on_language } from "../texts/texts";
import { h } from "../ui/dom";
import { Borrowed, off_told } from "./parts";

export class RestartTab {
  readonly element = h("div", { class: "panel-tab operator" });
  private off = h("p", { class: "note" });
  private borrowed: Borrowed[];

  constructor(
    app: App,
    private panel: OperatorPanel,
    operator: Operator,
  ) {
    this.borrowed = [panel.restart.element, panel.watch.element].map((e) => new Borrowed(e));
    this.element.append(this.off);
    const draw = (): void => {
      this.off.textContent = off_told(app);
      this.off.hidden = Boolean(operator.panel);
    };
    operator.on_panel.on(draw);
    app.on_opened.on(draw);
    on_language(draw);
    draw();
  }

  open(): void {
    for (const b of this.borrowed) b.take(this.element);
    this.panel.restart.element.open = true;
  }
  close(): void {
    for (const b of this.borrowed) b.give_back();
  }
}
