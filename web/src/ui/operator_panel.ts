// The panel of a machine: positions, keys, switches, lines by hand (MDI), axes by hand, stop points.
import type { App } from "../model/app";
import { alarm_told } from "../model/alarm_told";
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import { on_language, t } from "../texts/texts";
import { button, fill, h } from "./dom";
import { PanelFigures } from "./panel_figures";
import { PanelHands } from "./panel_hands";
import { PanelKeys } from "./panel_keys";
import { RealMachinePanel, real_told } from "./real_machine";
import { RestartPanel } from "./restart_panel";
import { ShiftPanel } from "./shift_panel";
import { TablesPanel } from "./tables_panel";
import { TouchPanel, type TouchDoor } from "./touch_panel";
import { set, write } from "./update";
import { WatchPanel } from "./watch_panel";

export class OperatorPanel {
  readonly element = h("div", { class: "operator" });
  private head = h("div", { class: "operator-head", "aria-live": "polite" });
  private keys: PanelKeys;
  private figures: PanelFigures;
  private hands: PanelHands;
  readonly restart: RestartPanel;
  readonly tables: TablesPanel;
  readonly touch: TouchPanel;
  readonly watch: WatchPanel;
  readonly shift: ShiftPanel;
  private real: RealMachinePanel;
  private now = {
    mode: h("span", { class: "mode" }),
    name: h("b", { class: "grow" }),
    line: h("span", { class: "dim" }),
    block: h("code", { class: "block-text" }),
  };
  private age = h("span", { class: "dim" }); // of the position of a real machine
  private said_drawn = "";
  private drawn = ""; // the state for which keys and hand controls were drawn

  constructor(
    private app: App,
    private operator: Operator,
    private show_line: (line: number) => void,
    ask_touch: TouchDoor["ask"],
  ) {
    this.keys = new PanelKeys(operator);
    this.real = new RealMachinePanel(app, operator);
    this.figures = new PanelFigures(operator);
    this.hands = new PanelHands(operator, () => this.draw());
    this.restart = new RestartPanel(app, operator);
    this.tables = new TablesPanel(app, operator, (edited) => {
      if (!operator.name || (Object.keys(edited).length === 0 && app.tables?.file !== operator.name)) return;
      app.tables = { file: operator.name, edited };
      if (app.opened?.file === operator.name) void app.run_again();
    });
    this.touch = new TouchPanel(app, operator, { ask: ask_touch, zero: () => this.tables.zero() });
    this.watch = new WatchPanel(operator, show_line);
    this.shift = new ShiftPanel(operator);
    this.element.append(
      this.head,
      this.keys.element,
      this.figures.element,
      this.hands.element,
      this.touch.element,
      this.restart.element,
      this.tables.element,
      this.watch.element,
      this.shift.element,
    );
    operator.on_panel.on(() => this.draw());
    for (const s of [app.on_opened, app.on_done]) s.on(() => this.draw());
    on_language(() => {
      this.drawn = this.said_drawn = "";
      this.figures.clear();
      this.draw();
    });
    this.draw();
  }

  private draw(): void {
    const p = this.operator.panel;
    if (!p) {
      const o = this.app.opened,
        file = o?.file;
      this.drawn = this.said_drawn = "";
      fill(
        this.head,
        h("p", { class: "note" }, t(file ? "panel_off" : "panel_no_program")),
        button(
          t("switch_on"),
          () => {
            if (file) void this.operator.switch_on({ file, ...this.app.choice });
          },
          { class: "main", disabled: !file, title: t("switch_on_long") },
        ),
        this.real.element,
      );
      this.real.show();
      this.keys.clear();
      this.figures.clear();
      return fill(this.hands.element);
    }
    this.draw_head(p);
    this.figures.draw(p);
    this.keys.show_shares(p);
    const wanted = JSON.stringify([
      p.mode,
      p.holds,
      p.single,
      p.optional_stop,
      p.skip,
      p.dry_feed,
      p.can_undo,
      p.asks,
      this.hands.state,
      p.diameters,
      Boolean(p.real),
    ]);
    if (wanted === this.drawn) return;
    this.drawn = wanted;
    this.keys.draw(p);
    this.hands.draw(p);
  }

  private draw_head(p: Panel): void {
    const told = [
        p.real?.state,
        p.real?.lost,
        p.real?.locked,
        p.mode,
        p.why,
        p.goes_there,
        p.told,
        p.asks,
        p.takes_tables,
        p.not_kept,
        p.alarm,
        p.holds,
      ],
      wanted = JSON.stringify([told, this.operator.stood]);
    const { mode, name, line, block } = this.now;
    set(mode, "class", `mode ${p.mode}`);
    write(mode, t(`mode_${p.mode}`));
    write(name, this.operator.name ?? "");
    write(line, t("line_n", { line: p.line }));
    write(block, p.text);
    write(this.age, p.real ? t("real_age", { port: p.real.port, ms: Math.round(p.real.age * 1000) }) : "");
    if (wanted === this.said_drawn) return; // a button that was drawn again would lose the finger that holds it
    this.said_drawn = wanted;
    fill(
      this.head,
      h("div", { class: "row" }, mode, name, line),
      block,
      this.age,
      ...real_told(p, this.operator),
      ...this.said(p),
    );
  }

  /// What the machine says, with the buttons to answer it.
  private said(p: Panel): (HTMLElement | false | null)[] {
    const told = (text: string): HTMLElement => h("p", { class: "told" }, text);
    return [
      p.why !== "" &&
        p.mode === "standing" &&
        told(p.why === "restart" ? t("why_restart") : t("stands_by", { code: p.why })),
      p.goes_there && told(t("goes_there")),
      p.told !== "" && told(p.told),
      p.asks && this.answers(p),
      p.takes_tables && h("p", { class: "note" }, t("takes_tables")),
      p.not_kept !== "" && h("p", { class: "told alarm" }, t("not_kept", { why: p.not_kept })),
      this.stood(p),
      p.alarm && this.alarm(p.alarm),
      !p.holds &&
        h(
          "p",
          { class: "note" },
          t("others_hold"),
          " ",
          button(t("take_controls"), () => this.operator.press("take")),
        ),
    ];
  }

  private answers(p: Panel): HTMLElement {
    const answers = [
      ["answer_ok", 1],
      ["answer_yes", 2],
      ["answer_no", 3],
      ["answer_cancel", 0],
    ] as const;
    return h(
      "div",
      { class: "row" },
      ...answers.map(([text, answer]) =>
        button(t(text), () => void this.operator.ask("answer", { answer }), { disabled: !p.holds, "data-starts": "" }),
      ),
    );
  }

  private alarm(alarm: NonNullable<Panel["alarm"]>): HTMLElement {
    const { hint, line, file, file_name } = alarm;
    const where =
      line > 0 &&
      (file === 0
        ? button(t("line_n", { line }), () => this.show_line(line), { class: "to-line" })
        : `${file_name ?? ""}:${line}`);
    return h("p", { class: "told alarm" }, `${alarm_told(alarm)}${hint ? ` ${hint}` : ""} `, where);
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
}
