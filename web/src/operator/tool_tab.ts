// The tab of the tool in the spindle, its offsets, and the zero: touching the part, and the tables.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import { axis_name, no_diameters } from "../model/diameters";
import type { Panel } from "../protocol/types";
import type { OperatorPanel } from "../ui/operator_panel";
import { t } from "../texts/texts";
import { h } from "../ui/dom";
import { axis_value } from "../ui/figures";
import { write } from "../ui/update";
import { Borrowed, off_told } from "./parts";

export class ToolTab {
  readonly element = h("div", { class: "panel-tab operator" });
  private tool = h("p", { class: "tool-told" });
  private zero = h("p", { class: "tool-told" });
  private borrowed: Borrowed[];

  constructor(
    private app: App,
    private operator: Operator,
    private panel: OperatorPanel,
  ) {
    this.borrowed = [panel.touch.element, panel.tables.element].map((e) => new Borrowed(e));
    this.element.append(this.tool, this.zero);
  }

  open(): void {
    for (const b of this.borrowed) b.take(this.element);
    this.panel.tables.element.open = true;
  }
  close(): void {
    for (const b of this.borrowed) b.give_back();
  }

  show(p: Panel | null): void {
    if (!p) {
      write(this.tool, off_told(this.app));
      return write(this.zero, "");
    }
    const of = p.diameters ?? no_diameters,
      axes = this.operator.axes.filter((a) => p.zero[a] !== undefined);
    write(this.tool, t("op_tool_told", { tool: p.tool ?? "–", H: p.offsets.H ?? "–", D: p.offsets.D ?? "–" }));
    const code = p.modal.find((m) => /^G5[4-9](\.\d)?$/.test(m.code))?.code ?? t("op_zero_in_force");
    write(this.zero, `${code}: ${axes.map((a) => `${axis_name(a, of)} ${axis_value(a, p.zero[a], of)}`).join("  ")}`);
  }
}
