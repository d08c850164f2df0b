// The tab to go on in the middle of the program, with stop points and watches.
import type { Operator } from "../model/operator";
import type { OperatorPanel } from "../ui/operator_panel";
import { on_language, t } from "../texts/texts";
import { h } from "../ui/dom";
import { Borrowed } from "./parts";

export class RestartTab {
  readonly element = h("div", { class: "panel-tab operator" });
  private off = h("p", { class: "note" });
  private borrowed: Borrowed[];

  constructor(
    private panel: OperatorPanel,
    operator: Operator,
  ) {
    this.borrowed = [panel.restart.element, panel.watch.element].map((e) => new Borrowed(e));
    this.element.append(this.off);
    const draw = (): void => {
      this.off.textContent = t("panel_off");
      this.off.hidden = Boolean(operator.panel);
    };
    operator.on_panel.on(draw);
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
