// A machine at its panel: a line of its own to the server, so that no cut and no long run keeps it waiting, and what it shows, as often as pictures are drawn.
import { Client, Lost, type LineState, type Socket } from "../protocol/client";
import { token } from "../protocol/token";
import type { OpenQuestion, Panel, PanelKey, Questions, Stood } from "../protocol/types";
import { language } from "../texts/texts";
import { Signal } from "./signal";

const moving = 30, standing = 250; // ms between two looks
const after_act = 10, act_lasts = 400; // ms: what a press does shows at once

export class Operator {
  panel: Panel | null = null;          // null: no machine is on
  axes: string[] = [];
  stood: Stood | null = null;          // in mid program, when the server ended
  readonly on_panel = new Signal<Panel | null>();
  readonly on_error = new Signal<string>();
  readonly on_stood = new Signal<void>(); // it has come to stand
  private client: Client | null = null;
  private question: OpenQuestion | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private looking = false;
  private acted_at = -1e9;
  private again = false; // asked for while it is looking: what comes may be from before

  constructor(private make: () => Socket) {}

  get name(): string | null { return this.question?.file ?? null; }

  /// Switches the machine of a program on, or looks at it if it is on.
  async switch_on(question: OpenQuestion): Promise<void> {
    const { text: _, ...of_disk } = question;
    this.question = of_disk;
    if (!this.client) {
      this.client = new Client(this.make, async (c) => { const t = token(); await c.ask("hello", t ? { token: t, lang: language() } : { lang: language() }); });
      this.client.line.on((l) => void this.line_changed(l));
      return this.client.connect();
    }
    await this.attach();
  }

  press(key: PanelKey): void { void this.ask("press", { key }).then(() => { if (key === "off") this.leave(); }); }

  /// Refusals are told; the panel shows at once what came of it, unless it is only looked at.
  async ask<K extends keyof Questions>(what: K, body: Questions[K][0], acts = true): Promise<Questions[K][1] | null> {
    if (!this.client) return null;
    try {
      const answer = await this.client.ask(what, body);
      if (acts) { this.acted_at = performance.now(); this.look_soon(0); }
      return answer;
    } catch (e) {
      if (!(e instanceof Lost)) this.on_error.emit(e instanceof Error ? e.message : String(e));
      return null;
    }
  }

  private async line_changed(line: LineState): Promise<void> {
    if (line === "open") return this.attach();
    if (line === "lost") { this.panel = null; this.on_panel.emit(null); }
  }

  private async attach(): Promise<void> {
    if (!this.question) return;
    const on = await this.ask("machine", this.question);
    if (!on) return this.leave();
    this.axes = on.axes;
    this.stood = on.stood;
    this.look_soon(0);
  }

  private leave(): void {
    clearTimeout(this.timer);
    this.question = this.panel = null;
    this.on_panel.emit(null);
  }

  private look_soon(ms: number): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.look(), ms);
  }

  private async look(): Promise<void> {
    if (this.looking) this.again = true;
    if (this.looking || !this.client || !this.question) return;
    this.looking = true, this.again = false;
    try {
      const before = this.panel;
      this.panel = await this.client.ask("panel", {});
      this.on_panel.emit(this.panel);
      const { mode, takes_tables } = this.panel;
      if (before && (before.mode !== mode || before.takes_tables !== takes_tables) && mode !== "running" && !takes_tables) this.on_stood.emit();
      if (mode === "running") this.stood = null;
    } catch (e) {
      if (!(e instanceof Lost)) this.leave(); // off; one that is lost comes back by itself
    }
    this.looking = false;
    if (this.panel) this.look_soon(this.again ? 0 : performance.now() - this.acted_at < act_lasts ? after_act : this.panel.mode === "running" ? moving : standing);
  }
}
