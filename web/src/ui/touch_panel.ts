// Touching the part: a click on it, the approach, the resulting work offset.
import type { App } from "../model/app";
import { remember, remembered } from "../model/memory";
import type { Operator } from "../model/operator";
import { touch_at, type Touch, type TouchRules } from "../model/touch";
import type { Point } from "../scene/scene";
import { on_language, t } from "../texts/texts";
import { button, fill, h, redraw } from "./dom";
import { axis_name, diameter_sign, factor, is_diameter, no_diameters } from "../model/diameters";
import { coordinate } from "./figures";
import { toast } from "./toast";

export interface TouchDoor {
  /// Sends a click on the part here; null: no longer.
  ask(touched: ((place: Point, normal: Point) => void) | null): void;
  /// Shifts the work offset in force along an axis, mm; null if there is none that can be shifted.
  zero(): { code: string; shift(axis: string, by: number): void } | null;
}

export class TouchPanel {
  readonly element = h("details", { class: "touch" });
  private body = h("div");
  private rules: Omit<TouchRules, "clearance"> = remembered("touch", { away: 5, feed: 100, radius: 0 });
  private clearance: number | null = null;
  private chosen: Touch | null = null;
  private gone = false; // the approach was executed
  private drawn = "";

  constructor(
    private app: App,
    private operator: Operator,
    private door: TouchDoor,
  ) {
    operator.on_panel.on((p) => {
      if (!p) this.element.open = false;
      this.draw();
    });
    operator.on_stood.on(() => this.draw());
    on_language(() => {
      this.drawn = "";
      this.draw();
    });
    this.element.addEventListener("toggle", () => {
      this.listen();
      this.draw();
    });
    app.on_opening.on(() => {
      this.clearance = null;
      this.chosen = null;
    });
    this.draw();
  }

  private listen(): void {
    this.door.ask(this.element.open ? (place, normal) => this.choose(place, normal) : null);
  }

  /// Above everything on the program's path.
  private over(): number {
    const p = this.operator.panel,
      all = this.app.done?.extents.all,
      zero = this.app.done?.zero;
    return (
      this.clearance ?? (p && all && zero ? Math.round(1000 * (all[1][2]! + zero[2] - (p.zero["Z"] ?? 0))) / 1000 : 0)
    );
  }

  private choose(place: Point, normal: Point): void {
    const p = this.operator.panel,
      zero = this.app.done?.zero;
    if (!p || !zero || this.app.opened?.file !== this.operator.name) return;
    this.chosen = touch_at(place, normal, zero, p, { ...this.rules, clearance: this.over() });
    this.gone = false;
    if (!this.chosen) toast(t("touch_none"), true);
    this.draw();
  }

  private async go(): Promise<void> {
    const { chosen } = this;
    if (!chosen || !(await this.operator.ask("lead", { way: chosen.way }))) return;
    this.gone = true;
    this.draw();
  }

  private draw(): void {
    const p = this.operator.panel;
    this.element.hidden = !p || Boolean(p.real); // a real machine does not touch the part that Kadr has cut
    if (!p) return;
    const may = p.holds && ["standing", "ended"].includes(p.mode),
      wanted = JSON.stringify([
        may,
        this.element.open,
        this.chosen,
        this.gone,
        this.rules,
        this.over(),
        p.takes_tables,
      ]);
    if (wanted === this.drawn) return;
    this.drawn = wanted;
    fill(
      this.element,
      h("summary", null, h("b", null, t("touch")), " ", h("span", { class: "dim" }, t("in_mm"))),
      this.body,
    );
    if (this.element.open)
      redraw(this.body, () =>
        fill(
          this.body,
          h("p", { class: "note" }, t("touch_how")),
          this.fields(),
          this.chosen && this.result(this.chosen, may),
        ),
      );
  }

  private fields(): HTMLElement {
    const field = (
      name: "touch_clearance" | "touch_away" | "touch_feed" | "touch_radius",
      value: number,
      set: (v: number) => void,
    ): HTMLElement => {
      const input = h("input", {
        size: "6",
        inputmode: "decimal",
        value: String(value),
        "aria-label": t(name),
        onchange: () => {
          const v = Number(input.value.replace(",", "."));
          if (Number.isFinite(v) && (name === "touch_clearance" || v >= 0)) set(v);
          this.chosen = null;
          remember("touch", this.rules);
          this.draw();
        },
      });
      return h("label", { class: "field" }, h("span", null, t(name)), input);
    };
    return h(
      "div",
      { class: "row wrap" },
      field("touch_clearance", this.over(), (v) => {
        this.clearance = v;
      }),
      field("touch_away", this.rules.away, (v) => {
        this.rules.away = v;
      }),
      field("touch_feed", this.rules.feed, (v) => {
        this.rules.feed = v;
      }),
      field("touch_radius", this.rules.radius, (v) => {
        this.rules.radius = v;
      }),
    );
  }

  private result(touch: Touch, may: boolean): HTMLElement {
    const of = this.operator.panel?.diameters ?? no_diameters;
    const zero = this.door.zero(),
      wanted = h("input", { size: "8", value: "0", inputmode: "decimal", "aria-label": t("value") });
    const set = (): void => {
      const v = Number(wanted.value.replace(",", "."));
      if (zero && Number.isFinite(v)) {
        zero.shift(touch.axis, touch.at - v / factor(touch.axis, of));
        this.chosen = null;
        this.draw();
      }
    };
    return h(
      "div",
      null,
      h(
        "div",
        { class: "row" },
        h(
          "span",
          null,
          t("touch_place", {
            axis: touch.axis,
            sense: touch.sense > 0 ? "−" : "+",
            at: `${is_diameter(touch.axis, of) ? `${diameter_sign} ` : ""}${coordinate(factor(touch.axis, of) * touch.at)}`,
          }),
        ),
        button(t("touch_go"), () => void this.go(), { class: "main", disabled: !may }),
      ),
      this.gone &&
        may &&
        (zero
          ? h(
              "div",
              { class: "row" },
              h("span", null, t("touch_zero", { code: zero.code })),
              h("b", null, axis_name(touch.axis, of)),
              h("span", null, "="),
              wanted,
              button(t("touch_off_set"), set, { disabled: this.operator.panel!.takes_tables }),
            )
          : h("p", { class: "note" }, t("touch_no_zero"))),
    );
  }
}
