// Start, Hold, Stop: always at the same place, whatever the tab shows.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import { t } from "../texts/texts";
import { button, h } from "../ui/dom";
import { enable, mark, set, write } from "../ui/update";
import { toggle } from "./parts";

export class BigKeys {
  readonly element = h("div", { class: "big-keys", role: "toolbar" });
  private on = button("", () => this.switch_on(), { class: "big main" });
  private start = button("", () => this.press_start(), {
    class: "big start",
    "data-starts": "",
    "aria-keyshortcuts": "R",
  });
  private hold = button("", () => this.press_hold(), { class: "big hold", "aria-keyshortcuts": "P Escape" });
  private stop = button("", () => this.operator.press("emergency"), {
    class: "big emergency",
    "aria-keyshortcuts": "F1",
  });
  private reset = button("", () => this.operator.press("reset"), { class: "big", "aria-keyshortcuts": "Escape" });
  private single = toggle((single) => void this.operator.ask("switches", { single }), { class: "big small" });
  private optional = toggle((optional_stop) => void this.operator.ask("switches", { optional_stop }), {
    class: "big small",
  });
  private take = button("", () => this.operator.press("take"), { class: "big main" });

  constructor(
    private app: App,
    private operator: Operator,
    private released: () => void,
  ) {
    this.element.append(this.on, this.take, this.start, this.hold, this.stop, this.reset, this.single, this.optional);
    this.show(null);
  }

  /// Starts or continues the program, if it may be started.
  press_start(): void {
    if (!this.start.disabled && !this.start.hidden) this.operator.press("run");
  }
  press_hold(): void {
    this.released();
    if (this.operator.panel?.holds) this.operator.press("hold");
  }
  press_stop(): void {
    this.released();
    if (this.operator.panel) this.operator.press("emergency");
  }
  press_reset(): void {
    if (!this.reset.disabled) this.operator.press("reset");
  }

  show(p: Panel | null): void {
    const texts: [HTMLElement, string, string][] = [
      [this.on, t(p ? "op_load" : "switch_on"), t(p ? "op_load_long" : "switch_on_long")],
      [this.take, t("take_controls"), t("others_hold")],
      [this.start, t(p?.mode === "held" ? "op_continue" : "press_run"), t("op_start_long")],
      [this.hold, t("press_hold"), t("op_hold_long")],
      [this.stop, t(p?.real ? "press_stop" : "press_emergency"), t(p?.real ? "press_stop_long" : "op_stop_long")],
      [this.reset, t("press_reset"), t("press_reset_long")],
      [this.single, t("single"), t("single_long")],
      [this.optional, "M1", t("optional_stop_long")],
    ];
    for (const [e, text, long] of texts) {
      write(e, text);
      set(e, "title", long);
    }
    set(this.element, "aria-label", t("panel"));
    const holds = Boolean(p?.holds),
      can_run = holds && !["alarm", "emergency", "running"].includes(p!.mode) && !p!.asks;
    // Another program is open than the machine has: it can be loaded while the machine stands.
    const other = this.app.opened && this.app.opened.file !== this.operator.name;
    this.on.hidden = Boolean(p) && !(other && ["standing", "ended"].includes(p!.mode));
    this.take.hidden = !p || holds;
    this.start.hidden = !p || !holds;
    enable(this.on, Boolean(this.app.opened));
    enable(this.start, can_run);
    enable(this.hold, holds && p!.mode === "running");
    enable(this.stop, Boolean(p));
    enable(this.reset, holds);
    enable(this.single, holds);
    enable(this.optional, holds);
    set(this.single, "aria-pressed", String(Boolean(p?.single)));
    set(this.optional, "aria-pressed", String(Boolean(p?.optional_stop)));
    mark(this.start, "main", can_run);
  }

  private switch_on(): void {
    const file = this.app.opened?.file;
    if (file) void this.operator.switch_on({ file, ...this.app.choice });
  }
}
