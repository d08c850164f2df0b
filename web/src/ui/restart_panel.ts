// Going on in the middle of a program: a form that asks for the place, and below it the sheet of the place that was found.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import { Restart } from "../model/restart";
import type { RestartPlace } from "../protocol/types";
import { on_language, t, type TextKey } from "../texts/texts";
import { button, fill, h, redraw } from "./dom";
import { RestartSheetView } from "./restart_sheet";

export class RestartPanel {
  readonly element = h("details", { class: "restart" });
  readonly restart: Restart;
  private body = h("div");
  private sheet: RestartSheetView;
  private drawn = "";

  constructor(
    private app: App,
    private operator: Operator,
  ) {
    this.restart = new Restart(operator);
    this.sheet = new RestartSheetView(app, operator, this.restart);
    this.restart.on_change.on(() => this.draw());
    operator.on_panel.on(() => this.draw());
    on_language(() => {
      this.drawn = "";
      this.draw();
    });
    this.element.addEventListener("toggle", () => this.draw());
    this.draw();
  }

  /// Starts from a position that is already known.
  async find(place: RestartPlace): Promise<void> {
    this.restart.leave.clear();
    await this.restart.find(place);
    this.propose_clearance();
    this.body.querySelector(".restart-sheet")?.scrollIntoView({ block: "nearest" });
  }

  private draw(): void {
    const p = this.operator.panel,
      { restart: r } = this;
    this.element.hidden = !p;
    if (!p) return;
    const may = p.holds && ["standing", "ended"].includes(p.mode);
    const wanted = JSON.stringify([may, p.diameters, r.sheet, r.ways, [...r.leave], r.searching, this.element.open]);
    if (wanted === this.drawn) return;
    this.drawn = wanted;
    fill(
      this.element,
      h("summary", null, h("b", null, t("restart")), " ", h("span", { class: "dim" }, t("in_mm"))),
      this.body,
    );
    if (!this.element.open) return;
    redraw(this.body, () =>
      fill(
        this.body,
        this.form(may),
        r.searching && h("p", { class: "note", "aria-live": "polite" }, t("restart_searching")),
        r.sheet && this.sheet.draw(may),
      ),
    );
  }

  private form(may: boolean): HTMLElement {
    const place = this.restart.place,
      number = (name: TextKey, value: number | undefined): HTMLInputElement =>
        h("input", {
          size: "6",
          inputmode: "numeric",
          "aria-label": t(name),
          placeholder: t(name),
          value: value ? String(value) : "",
        });
    const line = number("stop_line", place?.line ?? this.app.state?.line),
      pass = number("restart_pass", place?.pass),
      hole = number("restart_hole", place?.hole);
    const call = h("input", {
      size: "8",
      "aria-label": t("restart_call"),
      placeholder: t("restart_call"),
      value: place?.call ?? "",
    });
    const find = (): void => {
      const wish: RestartPlace = {};
      for (const [key, input] of [
        ["line", line],
        ["pass", pass],
        ["hole", hole],
      ] as const)
        if (Number(input.value) > 0) wish[key] = Math.round(Number(input.value));
      if (call.value.trim()) wish.call = call.value.trim();
      void this.find(wish);
    };
    const on_enter = (e: KeyboardEvent): void => {
      if (e.key === "Enter" && may) find();
    };
    return h(
      "div",
      { class: "row wrap", onkeydown: on_enter },
      ...[line, pass, call, hole].map((i) =>
        h("label", { class: "field" }, h("span", null, i.getAttribute("aria-label")), i),
      ),
      button(t("restart_find"), find, { disabled: !may }),
      this.restart.sheet && button(t("restart_forget"), () => this.restart.forget()),
    );
  }

  /// Above everything on the program's path.
  private propose_clearance(): void {
    const { sheet: s, rules } = this.restart,
      all = this.app.done?.extents.all,
      zero = this.app.done?.zero;
    if (!s || rules.clearance !== undefined || s.normal !== "Z" || !all || !zero) return;
    const origin = s.rows.find((r) => r.kind === "origin" && r.name === "Z")?.wanted;
    if (typeof origin === "number")
      this.restart.set_rules({ clearance: Math.round(1000 * (all[1][2]! + zero[2] - origin)) / 1000 });
  }
}
