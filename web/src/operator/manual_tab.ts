// The tab to move axes by hand: held keys, steps, a wheel; zero, to the zero, home; a line by hand.
import type { App } from "../model/app";
import { axis_name, factor, no_diameters, type Diameters } from "../model/diameters";
import { HeldJog, StepJog } from "../model/jog";
import { offset_code, set_zero } from "../model/machine_zero";
import { remember, remembered } from "../model/memory";
import type { Operator } from "../model/operator";
import type { Axes, Panel } from "../protocol/types";
import { t } from "../texts/texts";
import { button, fill, h, option } from "../ui/dom";
import { toast } from "../ui/toast";
import { MdiLine } from "../ui/mdi_line";
import { enable } from "../ui/update";
import { off_told } from "./parts";
import { go_home, go_to_zero, lead } from "./ways";
import { Wheel } from "./wheel";

export const steps = [0.001, 0.01, 0.1, 1, 10];
/// mm/min; 0: as fast as possible
const feeds = [100, 300, 1000, 3000, 0];

interface Key {
  axis: string;
  channel: number;
  name: string;
}

export class ManualTab {
  readonly element = h("div", { class: "manual-tab" });
  private held: HeldJog;
  private stepping: StepJog;
  private step = remembered<number>("op_step", 0); // mm or degrees; 0: as long as the key is held
  private feed = remembered<number>("op_jog_feed", 1000);
  private wheel: Wheel;
  private mdi: MdiLine;
  private moves: HTMLButtonElement[] = []; // enabled while the machine stands
  private shape = "";
  private may = false;

  constructor(
    private operator: Operator,
    private app: App,
  ) {
    this.held = new HeldJog(operator);
    this.stepping = new StepJog(operator);
    this.wheel = new Wheel((axis, turns) => this.make_steps({ axis, channel: 0, name: axis }, turns));
    this.mdi = new MdiLine(operator);
    for (const name of ["blur", "pagehide"]) window.addEventListener(name, () => this.release());
    document.addEventListener("visibilitychange", () => {
      if (document.hidden) this.release();
    });
  }

  /// Axes that move because a key is held slow down; steps that wait are forgotten.
  release(): void {
    this.held.release();
    this.stepping.clear();
  }
  release_held(): void {
    this.held.release();
  }
  renew(): void {
    this.shape = "";
  }

  show(p: Panel | null): void {
    const shape = p
      ? JSON.stringify([this.operator.axes, p.diameters, p.channels.map((c) => c.axes), this.step, this.feed])
      : off_told(this.app);
    if (shape !== this.shape) {
      this.shape = shape;
      if (p) this.draw(p);
      else fill(this.element, h("p", { class: "note" }, off_told(this.app)));
    }
    // A held key keeps its axis moving: it must stay enabled meanwhile.
    this.may = Boolean(p?.holds) && (["standing", "ended"].includes(p!.mode) || this.held.busy) && !p!.takes_tables;
    for (const b of this.moves) enable(b, this.may);
    if (p) this.mdi.show(p);
  }

  /// Moves an axis from a key of the keyboard; the axis moves until `release`.
  press(axis: string, sign: 1 | -1, fast: boolean): void {
    if (!this.may || !this.operator.axes.includes(axis)) return;
    if (this.step) this.make_steps({ axis, channel: 0, name: axis }, sign);
    else this.held.press(axis, sign, fast ? 0 : this.feed);
  }

  private diameters(channel: number): Diameters {
    const p = this.operator.panel;
    return (channel ? p?.channels.find((c) => c.number === channel)?.diameters : p?.diameters) ?? no_diameters;
  }

  private make_steps(k: Key, n: number): void {
    const size = (this.step || 0.01) / factor(k.axis, this.diameters(k.channel));
    this.stepping.step(k.axis, n, size, this.feed, k.channel);
  }

  private draw(p: Panel): void {
    this.release();
    this.moves = [];
    const several = p.channels.length > 1;
    const keys: Key[] = several
      ? p.channels.flatMap((c) => c.axes.map((axis) => ({ axis, channel: c.number, name: `${c.number}:${axis}` })))
      : this.operator.axes.map((axis) => ({ axis, channel: 0, name: axis }));
    fill(
      this.element,
      this.choices(),
      h("div", { class: "jog-rows" }, ...keys.flatMap((k) => this.row(k, several))),
      h(
        "div",
        { class: "row zeros" },
        ...(several
          ? []
          : [
              this.act(t("op_zero_all"), () => void this.zero(this.operator.axes), t("op_zero_all_long")),
              this.act(t("op_to_zero"), () => void go_to_zero(this.operator, this.app), t("op_to_zero_long"), true),
              this.act(t("op_home"), () => void go_home(this.operator), t("op_home_long"), true),
            ]),
      ),
      several ? null : this.wheel.draw(this.operator.axes),
      this.mdi.element,
    );
  }

  private choices(): HTMLElement {
    const one = (step: number): HTMLElement =>
      button(
        step ? String(step) : t("op_held"),
        () => {
          this.step = step;
          remember("op_step", step);
          this.show(this.operator.panel);
        },
        { "aria-pressed": this.step === step, title: step ? t("jog_step") : t("op_held_long") },
      );
    const feed = h(
      "select",
      {
        "aria-label": t("jog_feed"),
        onchange: () => {
          this.feed = Number(feed.value);
          remember("op_jog_feed", this.feed);
          this.show(this.operator.panel);
        },
      },
      ...feeds.map((f) => option(String(f), f ? `F ${f}` : t("op_rapid"), f === this.feed)),
    );
    return h(
      "div",
      { class: "row jog-choices" },
      h("span", { class: "switch", role: "group", "aria-label": t("jog_step") }, ...[0, ...steps].map(one)),
      feed,
    );
  }

  private row(k: Key, several: boolean): HTMLElement[] {
    const of = this.diameters(k.channel);
    const key = (sign: 1 | -1): HTMLElement => {
      const b = button(sign > 0 ? "+" : "−", () => {}, {
        class: "jog",
        "aria-label": `${k.name} ${sign > 0 ? "+" : "−"}`,
        title: this.step ? t("jog_step") : t("op_held_long"),
      });
      this.listen(b, k, sign);
      this.moves.push(b);
      return b;
    };
    return [
      h("b", { class: "jog-axis" }, several ? k.name : axis_name(k.axis, of)),
      key(-1),
      key(1),
      ...(several
        ? [h("span"), h("span")]
        : [
            this.act(t("op_zero"), () => void this.zero([k.axis]), t("op_zero_long", { axis: k.axis }), false, k.axis),
            this.act(
              "→ 0",
              () => void lead(this.operator, [{ [k.axis]: 0 }]),
              t("op_axis_to_zero", { axis: k.axis }),
              true,
              k.axis,
            ),
          ]),
    ];
  }

  private act(text: string, go: () => void, title: string, starts = false, of = ""): HTMLButtonElement {
    const b = button(text, go, {
      title,
      "aria-label": of ? `${of}: ${title}` : text,
      ...(starts ? { "data-starts": "" } : {}),
    });
    this.moves.push(b);
    return b;
  }

  /// By finger and mouse, and by Enter for a user who has only a keyboard.
  private listen(b: HTMLButtonElement, k: Key, sign: 1 | -1): void {
    const begin = (): void => {
      if (!this.may) return;
      if (this.step) this.make_steps(k, sign);
      else this.held.press(k.axis, sign, this.feed, k.channel);
    };
    b.addEventListener("pointerdown", (e) => {
      if (e.button !== 0) return;
      b.setPointerCapture(e.pointerId);
      begin();
    });
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"] as const)
      b.addEventListener(name, () => this.held.release());
    b.addEventListener("contextmenu", (e) => e.preventDefault());
    b.addEventListener("keydown", (e) => {
      if (e.key !== "Enter" || e.repeat) return;
      e.preventDefault();
      begin();
    });
    for (const name of ["keyup", "blur"] as const) b.addEventListener(name, () => this.held.release());
  }

  private async zero(axes: string[]): Promise<void> {
    const reads: Axes = Object.fromEntries(axes.map((a) => [a, 0]));
    if (!offset_code(this.operator)) return toast(t("op_no_zero"), true);
    await set_zero(this.operator, reads);
  }
}
