// The keys and switches of the panel: run, hold, reset, emergency stop, steps, overrides.
import { remembered } from "../model/memory";
import { most_feed, type Share } from "../model/overrides";
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import { t } from "../texts/texts";
import { button, fill, h } from "./dom";

const takes_effect = 500; // ms from moving a slider to a state that shows it

export class PanelKeys {
  readonly element = h("div", { class: "operator-keys-part" });
  private first = h("div", { class: "operator-keys first", role: "toolbar" });
  private keys = h("div", { class: "operator-keys", role: "toolbar" });

  private shares = new Map<Share, { input: HTMLInputElement; told: HTMLElement; moved_at: number }>();

  constructor(private operator: Operator) {
    this.element.append(this.first, this.keys);
  }

  clear(): void {
    fill(this.first);
    fill(this.keys);
    this.shares.clear();
  }

  /// The overrides of this state. The sliders stay the same: one that was drawn again would end the drag.
  show_shares(p: Panel): void {
    for (const [name, { input, told, moved_at }] of this.shares) {
      const percent = Math.round(100 * p[name]);
      if (!input.matches(":active") && performance.now() > moved_at + takes_effect) input.value = String(percent);
      told.textContent = `${percent} %`;
    }
  }

  private share(name: Share, p: Panel, most: number, least = 0): HTMLElement {
    const told = h("span", { class: "dim override" }),
      slider = { told, moved_at: -Infinity };
    const input = h("input", {
      type: "range",
      min: String(least),
      max: String(most),
      step: "5",
      disabled: !p.holds,
      "aria-label": t(`share_${name}`),
      oninput: () => {
        slider.moved_at = performance.now();
        void this.operator.ask("switches", { [name]: Number(input.value) / 100 });
      },
    });
    this.shares.set(name, Object.assign(slider, { input }));
    return h("label", { class: "field" }, h("span", null, t(`share_${name}`)), input, told);
  }

  draw(p: Panel): void {
    const { operator } = this,
      off = !p.holds,
      can_run = !off && !["alarm", "emergency"].includes(p.mode);
    this.first.setAttribute("aria-label", t("panel"));
    this.keys.setAttribute("aria-label", t("op_switches"));
    const toggle = (text: string, on: boolean, set: (on: boolean) => void, title: string): HTMLElement =>
      button(text, () => set(!on), { "aria-pressed": on, disabled: off, title });
    const dry = h("input", {
      size: "6",
      inputmode: "decimal",
      value: p.dry_feed ? String(p.dry_feed) : "",
      placeholder: "0",
      disabled: off,
      "aria-label": t("dry_run"),
      title: t("dry_run_long"),
      onchange: () => void operator.ask("switches", { dry_feed: Number(dry.value.replace(",", ".")) || 0 }),
    });
    fill(
      this.first,
      button(t("press_run"), () => operator.press("run"), {
        class: "main",
        "data-starts": "",
        disabled: !can_run || p.mode === "running",
      }),
      button(t("press_hold"), () => operator.press("hold"), { disabled: off || p.mode !== "running" }),
      button(t("press_reset"), () => operator.press("reset"), { disabled: off, title: t("press_reset_long") }),
      button(t(p.real ? "press_stop" : "press_emergency"), () => operator.press("emergency"), {
        class: "emergency",
        ...(p.real ? { title: t("press_stop_long") } : {}),
      }),
    );
    fill(
      this.keys,
      toggle(t("single"), p.single, (single) => void operator.ask("switches", { single }), t("single_long")),
      toggle(
        "M1",
        p.optional_stop,
        (optional_stop) => void operator.ask("switches", { optional_stop }),
        t("optional_stop_long"),
      ),
      ...(["block", "over", "out"] as const).map((key) =>
        button(t(`step_${key}`), () => operator.press(key), {
          disabled: !can_run || !["standing", "ended"].includes(p.mode),
          title: t(`step_${key}_long`),
          "data-starts": "",
        }),
      ),
      this.share("override", p, most_feed(remembered("override_200", false))),
      this.share("rapid", p, 100),
      this.share("spindle", p, 120, 50),
      h("label", { class: "field" }, h("span", null, t("dry_run")), dry),
      h(
        "details",
        { class: "skips" },
        h("summary", null, `${t("skip")} ${p.skip.join(" ")}`),
        h(
          "div",
          { class: "row" },
          ...[1, 2, 3, 4, 5, 6, 7, 8, 9].map((n) =>
            toggle(`/${n}`, p.skip.includes(n), (on) => void operator.ask("switches", { skip: n, on }), t("skip")),
          ),
        ),
      ),
      button(t("switch_off"), () => operator.press("off"), { disabled: off }),
    );
    this.show_shares(p);
  }
}
