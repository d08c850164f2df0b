// Axes by hand and a line by hand, in the panel.
import { factor, is_diameter, no_diameters, type Diameters } from "../model/diameters";
import { StepJog } from "../model/jog";
import { remember, remembered } from "../model/memory";
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import { t } from "../texts/texts";
import { button, fill, h, option } from "./dom";
import { MdiLine } from "./mdi_line";

const steps = [0.01, 0.1, 1, 10, 100];

export class PanelHands {
  readonly element = h("div");
  private step = 1;
  private mdi: MdiLine;
  private jog: StepJog;

  constructor(
    private operator: Operator,
    private changed: () => void,
  ) {
    this.mdi = new MdiLine(operator);
    this.jog = new StepJog(operator);
  }

  /// What is drawn depends on it.
  get state(): string {
    return `${this.step} ${this.jog.takes}`;
  }

  /// The axes in diameter programming of a channel; 0: the own one.
  private diameters(channel: number): Diameters {
    const p = this.operator.panel;
    return (channel ? p?.channels.find((c) => c.number === channel)?.diameters : p?.diameters) ?? no_diameters;
  }

  /// A touch with the probe of a real machine: along one axis, at most so far.
  private probe(p: Panel): HTMLElement {
    const ways = this.operator.axes.flatMap((axis) => [`${axis}-`, `${axis}+`]),
      may = p.holds && ["standing", "ended"].includes(p.mode);
    const field = (id: "real_probe_way" | "real_probe_feed", usual: string): HTMLInputElement => {
      const input = h("input", {
        value: remembered(id, usual),
        size: "4",
        inputmode: "decimal",
        "aria-label": t(id),
        onchange: () => remember(id, input.value),
      });
      return input;
    };
    const way = h(
      "select",
      { "aria-label": t("real_probe"), onchange: () => remember("real_probe", way.value) },
      ...ways.map((w) => option(w, w.replace("-", "\u2212"), w === remembered("real_probe", "Z-"))),
    );
    const most = field("real_probe_way", "20"),
      feed = field("real_probe_feed", "50"),
      number = (input: HTMLInputElement): number => Number(input.value.replace(",", ".")) || 0;
    const go = (): void => {
      const sign = way.value.endsWith("-") ? -1 : 1;
      void this.operator.ask("probe", { axis: way.value.slice(0, -1), way: sign * number(most), feed: number(feed) });
    };
    return h(
      "div",
      { class: "row wrap" },
      way,
      h("label", { class: "field" }, h("span", null, t("real_probe_way")), most),
      h("label", { class: "field" }, h("span", null, t("real_probe_feed")), feed),
      button(t("real_probe_go"), go, { disabled: !may, "data-starts": "" }),
    );
  }

  draw(p: Panel): void {
    const { operator } = this,
      off = !this.jog.takes;
    this.mdi.show(p);
    const feed = h("input", {
      value: remembered("jog_feed", "1000"),
      size: "6",
      inputmode: "decimal",
      "aria-label": t("jog_feed"),
      onchange: () => remember("jog_feed", feed.value),
    });
    const go = (axis: string, sign: 1 | -1, channel = 0): void => {
      const size = this.step / factor(axis, this.diameters(channel));
      this.jog.step(axis, sign, size, Number(feed.value.replace(",", ".")) || 0, channel);
    };
    const jog_title = (k: { axis: string; channel: number }): string =>
      is_diameter(k.axis, this.diameters(k.channel)) ? t("step_is_diameter") : "";
    const several = p.channels.length > 1,
      keys = several
        ? p.channels.flatMap((c) => c.axes.map((axis) => ({ axis, channel: c.number, name: `${c.number}:${axis}` })))
        : operator.axes.map((axis) => ({ axis, channel: 0, name: axis }));
    const step = h(
      "select",
      {
        "aria-label": t("jog_step"),
        onchange: () => {
          this.step = Number(step.value);
          this.changed();
        },
      },
      ...steps.map((s) => option(String(s), String(s), s === this.step)),
    );
    const key = (k: (typeof keys)[0], sign: 1 | -1): HTMLElement =>
      button(`${k.name}${sign > 0 ? "+" : "−"}`, () => go(k.axis, sign, k.channel), {
        disabled: off,
        "aria-label": `${k.name} ${sign > 0 ? "+" : "−"}`,
        title: jog_title(k),
      });
    const probe = p.real ? [h("h3", null, t("real_probe")), this.probe(p)] : [];
    const had_focus = document.activeElement === this.mdi.element.querySelector(".mdi");
    fill(
      this.element,
      h("h3", null, t("mdi")),
      this.mdi.element,
      h("h3", null, t("by_hand")),
      h(
        "div",
        { class: "row wrap" },
        h("label", { class: "field" }, h("span", null, t("jog_step")), step),
        h("label", { class: "field" }, h("span", null, t("jog_feed")), feed, h("span", { class: "dim" }, t("mm_min"))),
      ),
      h("div", { class: "jog-keys" }, ...keys.flatMap((k) => [key(k, -1), key(k, 1)])),
      ...probe,
    );
    if (had_focus) this.mdi.element.querySelector<HTMLInputElement>(".mdi")?.focus();
  }
}
