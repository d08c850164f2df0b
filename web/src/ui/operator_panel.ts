// The panel of a machine: positions, keys, switches, lines by hand (MDI), axes by hand, stop points.
import type { App } from "../model/app";
import { remember, remembered } from "../model/memory";
import type { Operator } from "../model/operator";
import type { Panel, PanelChannel } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h, option } from "./dom";
import { axis_name, factor, is_diameter, no_diameters, type Diameters } from "../model/diameters";
import { axis_unit, feed_unit, surface_unit, turn_unit } from "../model/units";
import { axis_value, feed, length, short, surface_figure } from "./figures";
import { RestartPanel } from "./restart_panel";
import { ShiftPanel } from "./shift_panel";
import { turning_offset } from "./state_pane";
import { TablesPanel } from "./tables_panel";
import { TouchPanel, type TouchDoor } from "./touch_panel";
import { WatchPanel } from "./watch_panel";

/// The speed of the spindle: rev/min, and with constant surface speed also that speed and the limit of G50.
function spindle_told(p: Panel): [string, string][] {
  const now = p.rpm === null ? "–" : `${short(p.rpm)} ${t("rev_min")}`;
  if (!p.surface) return [["S", now]];
  return [
    ["S", `${surface_figure(p.surface.speed)} ${surface_unit()}`],
    ["n", now],
    ["S max", p.surface.most === null ? "–" : `${short(p.surface.most)} ${t("rev_min")}`],
  ];
}

const steps = [0.01, 0.1, 1, 10, 100],
  most_history = 50;

export class OperatorPanel {
  readonly element = h("div", { class: "operator" });
  private head = h("div", { class: "operator-head", "aria-live": "polite" });
  private keys = h("div", { class: "operator-keys", role: "toolbar" });
  private figures = h("div", { class: "operator-figures" });
  private hands = h("div");
  readonly restart: RestartPanel;
  readonly tables: TablesPanel;
  private drawn = ""; // the state for which keys and hand controls were drawn
  private step = 1;
  private codes = { number: -1, now: new Set<string>(), before: new Set<string>() }; // in force at the block, and at the one before
  private history = remembered<string[]>("mdi", []);
  private at = -1; // in the history; -1: a new line

  constructor(
    private app: App,
    private operator: Operator,
    show_line: (line: number) => void,
    ask_touch: TouchDoor["ask"],
  ) {
    this.restart = new RestartPanel(app, operator);
    this.tables = new TablesPanel(app, operator, (edited) => {
      if (!operator.name || (Object.keys(edited).length === 0 && app.tables?.file !== operator.name)) return;
      app.tables = { file: operator.name, edited };
      if (app.opened?.file === operator.name) void app.run_again();
    });
    this.element.append(
      this.head,
      this.keys,
      this.figures,
      this.hands,
      new TouchPanel(app, operator, { ask: ask_touch, zero: () => this.tables.zero() }).element,
      this.restart.element,
      this.tables.element,
      new WatchPanel(operator, show_line).element,
      new ShiftPanel(operator).element,
    );
    operator.on_panel.on(() => this.draw());
    for (const s of [app.on_opened, app.on_done]) s.on(() => this.draw());
    on_language(() => {
      this.drawn = "";
      this.draw();
    });
    this.draw();
  }

  private draw(): void {
    const p = this.operator.panel;
    if (!p) {
      const o = this.app.opened,
        file = o?.file;
      this.drawn = "";
      fill(
        this.head,
        h("p", { class: "note" }, t("panel_off")),
        button(
          t("switch_on"),
          () => {
            if (file) void this.operator.switch_on({ file, ...this.app.choice });
          },
          { class: "main", disabled: !file, title: t("switch_on_long") },
        ),
      );
      return (fill(this.keys), fill(this.figures), fill(this.hands));
    }
    this.draw_head(p);
    this.draw_figures(p);
    const wanted = JSON.stringify([
      p.mode,
      p.holds,
      p.single,
      p.optional_stop,
      p.skip,
      p.override,
      p.rapid,
      p.spindle,
      p.dry_feed,
      p.can_undo,
      p.asks,
      this.step,
      p.diameters,
    ]);
    if (wanted === this.drawn) return;
    this.drawn = wanted;
    this.draw_keys(p);
    this.draw_hands(p);
  }

  private draw_head(p: Panel): void {
    fill(
      this.head,
      h(
        "div",
        { class: "row" },
        h("span", { class: `mode ${p.mode}` }, t(`mode_${p.mode}`)),
        h("b", { class: "grow" }, this.operator.name),
        h("span", { class: "dim" }, t("line_n", { line: p.line })),
      ),
      h("code", { class: "block-text" }, p.text),
      p.why &&
        p.mode === "standing" &&
        h("p", { class: "told" }, p.why === "restart" ? t("why_restart") : t("stands_by", { code: p.why })),
      p.goes_there && h("p", { class: "told" }, t("goes_there")),
      p.told && h("p", { class: "told" }, p.told),
      p.asks &&
        h(
          "div",
          { class: "row" },
          ...(
            [
              ["answer_ok", 1],
              ["answer_yes", 2],
              ["answer_no", 3],
              ["answer_cancel", 0],
            ] as const
          ).map(([text, answer]) =>
            button(t(text), () => void this.operator.ask("answer", { answer }), { disabled: !p.holds }),
          ),
        ),
      p.takes_tables && h("p", { class: "note" }, t("takes_tables")),
      p.not_kept && h("p", { class: "told alarm" }, t("not_kept", { why: p.not_kept })),
      this.stood(p),
      p.alarm && h("p", { class: "told alarm" }, `${p.alarm.text}${p.alarm.hint ? ` ${p.alarm.hint}` : ""}`),
      !p.holds &&
        h(
          "p",
          { class: "note" },
          t("others_hold"),
          " ",
          button(t("take_controls"), () => this.operator.press("take")),
        ),
    );
  }

  /// Shown after the server ended in the middle of a program.
  private stood(p: Panel): HTMLElement | null {
    const s = this.operator.stood;
    if (!s || p.mode !== "standing") return null;
    const go = (): void => {
      this.restart.element.open = true;
      void this.restart.find({ number: s.number, line: s.line, ...(s.file ? { of_file: s.file } : {}) });
    };
    return h(
      "p",
      { class: "told" },
      t("stood_at", { line: s.line, text: s.text.trim() }),
      " ",
      button(t("stood_go"), go, { disabled: !p.holds, class: "main" }),
      " ",
      button(t("restart_forget"), () => {
        this.operator.stood = null;
        this.draw();
      }),
    );
  }

  private share(name: "override" | "rapid" | "spindle", p: Panel, most: number, least = 0): HTMLElement {
    const input = h("input", {
      type: "range",
      min: String(least),
      max: String(most),
      step: "5",
      value: String(Math.round(100 * p[name])),
      disabled: !p.holds,
      "aria-label": t(`share_${name}`),
      oninput: () => void this.operator.ask("switches", { [name]: Number(input.value) / 100 }),
    });
    return h(
      "label",
      { class: "field" },
      h("span", null, t(`share_${name}`)),
      input,
      h("span", { class: "dim override" }, `${Math.round(100 * p[name])} %`),
    );
  }

  private draw_keys(p: Panel): void {
    const { operator } = this,
      off = !p.holds,
      can_run = !off && !["alarm", "emergency"].includes(p.mode);
    this.keys.setAttribute("aria-label", t("panel"));
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
      this.keys,
      button(t("press_run"), () => operator.press("run"), {
        class: "main",
        disabled: !can_run || p.mode === "running",
      }),
      button(t("press_hold"), () => operator.press("hold"), { disabled: off || p.mode !== "running" }),
      button(t("press_reset"), () => operator.press("reset"), { disabled: off, title: t("press_reset_long") }),
      button(t("press_emergency"), () => operator.press("emergency"), { class: "emergency" }),
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
        }),
      ),
      this.share("override", p, 100),
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
  }

  private draw_figures(p: Panel): void {
    if (p.number !== this.codes.number)
      this.codes = { number: p.number, now: new Set(p.modal.map((m) => m.code)), before: this.codes.now };
    const is_new = (code: string): boolean => this.codes.before.size > 0 && !this.codes.before.has(code);
    const of = p.diameters ?? no_diameters;
    const cell = (a: string, v: number | null | undefined): HTMLElement => h("td", null, axis_value(a, v, of));
    fill(
      this.figures,
      h(
        "table",
        { class: "positions big" },
        h(
          "thead",
          null,
          h(
            "tr",
            null,
            h("th", null),
            h("th", { scope: "col" }, t("work")),
            h("th", { scope: "col" }, t("machine_position")),
            h("th", { scope: "col" }, t("to_go")),
            h("th", null),
          ),
        ),
        h(
          "tbody",
          null,
          ...this.operator.axes.map((a) =>
            h(
              "tr",
              null,
              h("th", { scope: "row", title: is_diameter(a, of) ? t("is_diameter") : "" }, axis_name(a, of)),
              cell(a, p.position[a]),
              cell(a, p.machine[a]),
              cell(a, p.togo[a]),
              h("td", { class: "unit" }, axis_unit(a)),
            ),
          ),
        ),
      ),
      h(
        "div",
        { class: "row wrap" },
        ...(
          [
            ["F", `${feed(p.feed, 1)} ${feed_unit()}`],
            ...(typeof p.feed_per_turn === "number"
              ? ([["F", `${length(p.feed_per_turn)} ${turn_unit()}`]] as const)
              : []),
            ["V", `${feed(p.speed)} ${feed_unit()}`],
            ...spindle_told(p),
            ["T", p.tool ?? "–"],
            ...(p.tool_offset
              ? ([] as const)
              : ([
                  ["D", p.offsets.D ?? "–"],
                  ["H", p.offsets.H ?? "–"],
                ] as const)),
          ] as const
        ).map(([name, v]) => h("span", null, h("b", null, name), ` ${v}`)),
        p.tool_offset && h("span", { class: "figures turning-offset" }, ...turning_offset(p.tool_offset, of)),
        h("span", { class: "dim share" }, `${Math.floor(100 * p.share + 1e-6)} %`),
        h("span", { class: "dim limit", title: t("limit_long") }, p.limit),
      ),
      p.channels.length > 1 && this.channels(p.channels),
      h(
        "div",
        { class: "modal", role: "list", "aria-label": t("modal") },
        ...p.modal.map((m) =>
          h("span", { class: is_new(m.code) ? "code changed" : "code", role: "listitem", title: m.group }, m.code),
        ),
      ),
    );
  }

  /// Side by side, with which channel waits for which.
  private channels(all: PanelChannel[]): HTMLElement {
    const does = (c: PanelChannel): string =>
      c.waits
        ? t("waits_for", {
            code: c.waits.code,
            channels: c.waits.channels.filter((n) => !c.waits!.here.includes(n)).join(", ") || "–",
          })
        : c.moves
          ? t("channel_moves")
          : t("channel_stands");
    return h(
      "div",
      { class: "channels", role: "list" },
      ...all.map((c) =>
        h(
          "section",
          { class: c.waits ? "channel waits" : "channel", role: "listitem" },
          h(
            "div",
            { class: "row" },
            h("b", null, t("channel_n", { n: c.number })),
            h("span", { class: "grow" }, does(c)),
            h("span", { class: "dim" }, c.line ? t("line_n", { line: c.line }) : ""),
          ),
          h("code", { class: "block-text" }, c.text),
          h(
            "div",
            { class: "row wrap" },
            ...c.axes.map((a) =>
              h(
                "span",
                null,
                h("b", null, axis_name(a, c.diameters ?? [])),
                ` ${axis_value(a, c.position[a], c.diameters)}`,
              ),
            ),
          ),
        ),
      ),
    );
  }

  /// The axes in diameter programming of a channel; 0: the own one.
  private diameters(channel: number): Diameters {
    const p = this.operator.panel;
    return (channel ? p?.channels.find((c) => c.number === channel)?.diameters : p?.diameters) ?? no_diameters;
  }

  private draw_hands(p: Panel): void {
    const { operator } = this,
      off = !p.holds || !["standing", "ended"].includes(p.mode);
    const had_focus = document.activeElement === this.hands.querySelector(".mdi"),
      before = this.hands.querySelector<HTMLInputElement>(".mdi")?.value ?? "";
    const line = h("input", {
      class: "mdi wide",
      value: before,
      placeholder: "G0 X10",
      "aria-label": t("mdi"),
      spellcheck: "false",
      autocapitalize: "characters",
      onkeydown: (e: KeyboardEvent) => this.mdi_key(e, line, off),
    });
    const feed = h("input", {
      value: remembered("jog_feed", "1000"),
      size: "6",
      inputmode: "decimal",
      "aria-label": t("jog_feed"),
      onchange: () => remember("jog_feed", feed.value),
    });
    const go = (axis: string, way: number, channel = 0): void =>
      void operator.ask("jog", {
        axis,
        way: (way * this.step) / factor(axis, this.diameters(channel)),
        feed: Number(feed.value.replace(",", ".")) || 0,
        ...(channel ? { channel } : {}),
      });
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
          this.draw();
        },
      },
      ...steps.map((s) => option(String(s), String(s), s === this.step)),
    );
    fill(
      this.hands,
      h("h3", null, t("mdi")),
      h(
        "div",
        { class: "row" },
        line,
        button(t("enter_line"), () => this.enter(line), { disabled: off }),
        button(`${t("undo_line")}${p.can_undo ? ` (${p.can_undo})` : ""}`, () => void operator.ask("undo", {}), {
          disabled: off || !p.can_undo,
          title: t("undo_line_long"),
        }),
      ),
      h("h3", null, t("by_hand")),
      h(
        "div",
        { class: "row wrap" },
        h("label", { class: "field" }, h("span", null, t("jog_step")), step),
        h("label", { class: "field" }, h("span", null, t("jog_feed")), feed, h("span", { class: "dim" }, t("mm_min"))),
      ),
      h(
        "div",
        { class: "jog-keys" },
        ...keys.flatMap((k) => [
          button(`${k.name}−`, () => go(k.axis, -1, k.channel), {
            disabled: off,
            "aria-label": `${k.name} −`,
            title: jog_title(k),
          }),
          button(`${k.name}+`, () => go(k.axis, 1, k.channel), {
            disabled: off,
            "aria-label": `${k.name} +`,
            title: jog_title(k),
          }),
        ]),
      ),
    );
    if (had_focus) line.focus();
  }

  private mdi_key(e: KeyboardEvent, line: HTMLInputElement, off: boolean): void {
    if (e.key === "Enter" && !off) return this.enter(line);
    const way = e.key === "ArrowUp" ? 1 : e.key === "ArrowDown" ? -1 : 0;
    if (!way) return;
    e.preventDefault();
    this.at = Math.min(this.history.length - 1, Math.max(-1, this.at + way));
    line.value = this.at < 0 ? "" : this.history[this.at]!;
  }

  private enter(line: HTMLInputElement): void {
    const text = line.value.trim();
    if (!text) return;
    this.history = [text, ...this.history.filter((x) => x !== text)].slice(0, most_history);
    remember("mdi", this.history);
    this.at = -1;
    line.value = "";
    void this.operator.ask("enter", { line: text });
  }
}
