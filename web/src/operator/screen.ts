// The operator's screen: positions, the running block, overrides and the keys of the machine fill the window; tabs hold
// the rest. Panes of the page are borrowed while it is shown.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { Panel } from "../protocol/types";
import type { OperatorPanel } from "../ui/operator_panel";
import { on_language, t, type TextKey } from "../texts/texts";
import { button, h } from "../ui/dom";
import { Tabs } from "../ui/layout";
import { mark, set, write } from "../ui/update";
import { BigKeys } from "./big_keys";
import { Blocks } from "./blocks";
import { FullScreen } from "./full_screen";
import { ManualTab } from "./manual_tab";
import { MessagesTab } from "./messages_tab";
import { Notice } from "./notice";
import { OverrideRows } from "./override_rows";
import { Borrowed, off_told } from "./parts";
import { ProgramTab } from "./program_tab";
import { Readout } from "./readout";
import { RestartTab } from "./restart_tab";
import { ToolTab } from "./tool_tab";

export interface OperatorPanes {
  panel: OperatorPanel;
  banner: HTMLElement;
  files: HTMLElement;
  scene: HTMLElement;
  source: HTMLElement;
  problems: HTMLElement;
  show_line(line: number): void;
  help(): void;
}

export const tab_names = ["op_program", "op_manual", "op_tool_zero", "op_messages", "op_restart"] as const;
export type TabName = (typeof tab_names)[number];

export class OperatorScreen {
  readonly element = h("div", { class: "operator-screen", hidden: true });
  readonly keys: BigKeys;
  readonly overrides: OverrideRows;
  readonly manual: ManualTab;
  private mode = h("span", { class: "mode", role: "status" });
  private name = button("", () => this.to_files(), { class: "file" });
  private line = h("span", { class: "dim" });
  private off = h("p", { class: "screen-off" });
  private full = new FullScreen();
  private readout: Readout;
  private blocks: Blocks;
  private notice: Notice;
  private messages: MessagesTab;
  private program: ProgramTab;
  private tool: ToolTab;
  private restart: RestartTab;
  private tabs: Tabs;
  private banner: Borrowed;
  private shown: TabName = "op_program";
  private leave_button = button("", () => this.leave(), { class: "leave", "aria-keyshortcuts": "O" });
  private help_button = button("?", () => this.panes.help(), { class: "icon" });

  constructor(
    private app: App,
    private operator: Operator,
    private panes: OperatorPanes,
    private leave: () => void,
  ) {
    const to_line = (line: number): void => this.to_line(line);
    this.manual = new ManualTab(operator, app);
    this.keys = new BigKeys(app, operator, () => this.manual.release());
    this.overrides = new OverrideRows(operator);
    this.readout = new Readout(operator);
    this.blocks = new Blocks(operator, to_line);
    this.notice = new Notice(operator, this.blocks, to_line, () => app.opened?.control.id);
    this.messages = new MessagesTab(operator, panes.panel.shift.element, panes.problems, this.overrides, to_line);
    this.program = new ProgramTab(panes.scene, panes.source, panes.files, app);
    this.tool = new ToolTab(app, operator, panes.panel);
    this.restart = new RestartTab(app, panes.panel, operator);
    this.banner = new Borrowed(panes.banner);
    const pages: Record<TabName, HTMLElement> = {
      op_program: this.program.element,
      op_manual: this.manual.element,
      op_tool_zero: this.tool.element,
      op_messages: this.messages.element,
      op_restart: this.restart.element,
    };
    this.tabs = new Tabs(
      tab_names.map((name) => ({
        name: name as TextKey,
        element: pages[name],
        ...(name === "op_messages" ? { badge: () => this.messages.badge() } : {}),
      })),
      (name) => {
        this.shown = name as TabName;
        this.manual.release();
      },
    );
    this.element.append(
      h(
        "header",
        { class: "screen-head" },
        this.mode,
        this.name,
        this.line,
        h("span", { class: "grow" }),
        this.full.element,
        this.help_button,
        this.leave_button,
      ),
      this.notice.element,
      h(
        "main",
        { class: "screen-body" },
        h("div", { class: "screen-left" }, this.off, this.readout.element, this.blocks.element, this.overrides.element),
        this.tabs.element,
      ),
      this.keys.element,
    );
    operator.on_panel.on((p) => this.show(p));
    for (const s of [app.on_opened, app.on_opening]) s.on(() => this.show(operator.panel));
    on_language(() => {
      this.readout.renew();
      this.manual.renew();
      this.show(operator.panel);
    });
  }

  get tab(): TabName {
    return this.shown;
  }
  choose(name: TabName): void {
    this.tabs.choose(name as TextKey);
  }

  open(): void {
    this.element.hidden = false;
    this.banner.take(this.element);
    this.element.prepend(this.panes.banner);
    for (const tab of [this.program, this.tool, this.messages, this.restart]) tab.open();
    if (!this.app.opened && !this.operator.panel) this.program.show_files(true);
    this.show(this.operator.panel);
    dispatchEvent(new Event("resize"));
  }
  close(): void {
    this.manual.release();
    this.full.leave();
    this.element.hidden = true;
    this.banner.give_back();
    for (const tab of [this.program, this.tool, this.messages, this.restart]) tab.close();
    dispatchEvent(new Event("resize"));
  }

  private to_files(): void {
    this.choose("op_program");
    this.program.show_files();
  }
  private to_line(line: number): void {
    this.choose("op_program");
    this.program.show_text();
    this.panes.show_line(line);
  }

  private show(p: Panel | null): void {
    if (this.element.hidden) return;
    const mode = p ? p.mode : "off";
    write(this.mode, p ? t(`mode_${p.mode}`) : t("op_off"));
    set(this.mode, "class", `mode ${mode}`);
    write(this.name, (this.operator.name ?? this.app.opened?.file ?? t("no_program")).replace(/.*\//, ""));
    set(this.name, "title", `${t("op_choose")}: ${this.operator.name ?? this.app.opened?.file ?? ""}`);
    write(this.line, p?.line ? t("line_n", { line: p.line }) : "");
    write(this.leave_button, t("op_leave"));
    set(this.leave_button, "title", t("op_leave_long"));
    for (const name of ["title", "aria-label"]) set(this.help_button, name, t("keys"));
    this.full.draw();
    mark(this.element, "off", !p);
    write(this.off, p ? "" : off_told(this.app));
    this.off.hidden = Boolean(p);
    for (const e of [this.readout.element, this.blocks.element, this.overrides.element]) e.hidden = !p;
    if (p) {
      this.readout.show(p);
      this.blocks.show(p);
    }
    this.notice.show(p);
    this.overrides.show(p);
    this.keys.show(p);
    this.manual.show(p);
    this.tool.show(p);
    this.messages.show(p);
    if (this.messages.badge_changed()) this.tabs.draw();
  }
}
