// The part after the program: volumes, what each tool removes, the heaviest lines, collisions.
import type { App } from "../model/app";
import { on_language, t } from "../texts/texts";
import type { Problem } from "../protocol/types";
import { fill, h } from "../ui/dom";
import { volume_unit } from "../model/units";
import { clock, length_told, volume_figure, volume_told } from "../ui/figures";
import { CutProblems } from "../ui/problems_panel";
import { fact } from "../ui/summary";

export class FindingsPanel {
  readonly element = h("div", { class: "cut" });
  private hit: CutProblems;

  constructor(
    private app: App,
    jump: (p: Problem) => void,
  ) {
    this.hit = new CutProblems(app, jump);
    app.on_cut.on(() => this.draw());
    on_language(() => this.draw());
    this.draw();
  }

  badge(): string {
    return this.hit.badge();
  }

  private draw(): void {
    const { app } = this,
      c = app.cut;
    if (!c) return fill(this.element);
    fill(
      this.element,
      h(
        "dl",
        { class: "facts" },
        ...fact(t("stock"), volume_told(c.stock)),
        ...fact(t("removed"), volume_told(c.removed)),
        ...fact(t("left"), volume_told(c.left)),
        ...fact(t("cell"), length_told(c.resolution)),
      ),
      ...this.hit.rows(),
      this.tools(),
    );
  }

  private tools(): HTMLElement | null {
    const tools = this.app.cut?.tools ?? [];
    if (!tools.length) return null;
    return h(
      "table",
      { class: "list" },
      h(
        "thead",
        null,
        h(
          "tr",
          null,
          ...[
            t("tool"),
            `${t("removed")}, ${volume_unit()}`,
            t("time"),
            `${t("greatest_rate")}, ${volume_unit()}/${t("second")}`,
          ].map((x) => h("th", { scope: "col" }, x)),
        ),
      ),
      h(
        "tbody",
        null,
        ...tools.map((x) =>
          h(
            "tr",
            null,
            h("td", null, `T${x.tool}`),
            h("td", null, volume_figure(x.removed)),
            h("td", null, clock(x.seconds)),
            h("td", null, volume_figure(x.greatest_rate)),
          ),
        ),
      ),
    );
  }
}
