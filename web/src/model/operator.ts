// A machine at its panel: on a connection of its own to the server, so that no cut and no long run delays it. Its
// state is read as often as pictures are drawn.
import { Client, Lost, type LineState, type Socket } from "../protocol/client";
import type { Panel, PanelKey, Questions, RealQuestion, Stood } from "../protocol/types";
import { greet } from "./greet";
import { Signal } from "./signal";

const moving = 30,
  standing = 250; // ms from showing one state to requesting the next
const after_act = 15,
  act_lasts = 400; // ms: the effect of a key press shows at once
const most_drawn = 200; // ms limit for drawing a picture, for slow pages and pages that are not visible

/// Waits until the browser has drawn the last change: on a slow browser, key presses would otherwise wait for one
/// state after another.
const drawn = (): Promise<void> =>
  new Promise((yes) => {
    if (typeof requestAnimationFrame === "undefined" || document.hidden) return yes();
    const done = (): void => {
        clearTimeout(late);
        yes();
      },
      late = setTimeout(done, most_drawn);
    requestAnimationFrame(() => setTimeout(done, 0));
  });

export class Operator {
  panel: Panel | null = null; // null: no machine is on
  axes: string[] = [];
  stood: Stood | null = null; // the program was interrupted when the server ended
  readonly on_panel = new Signal<Panel | null>();
  readonly on_error = new Signal<string>();
  readonly on_stood = new Signal<void>(); // it has stopped
  readonly on_queued = new Signal<void>(); // a request has begun, and takes long
  readonly on_press = new Signal<void>(); // a key is pressed: its effect must show at once
  private client: Client | null = null;
  private question: RealQuestion | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private looks = 0; // requests in progress
  private acted_at = -1e9;
  private settles = false; // a line has been entered: it may be finished before the next state arrives

  constructor(private make: () => Socket) {}

  get name(): string | null {
    return this.question?.file ?? null;
  }

  /// Switches the machine of a program on, or connects to it if it is on.
  async switch_on(question: RealQuestion): Promise<void> {
    const { text: _, ...of_disk } = question;
    this.question = of_disk;
    if (!this.client) {
      this.client = new Client(this.make, greet);
      this.client.line.on((l) => void this.line_changed(l));
      return this.client.connect();
    }
    await this.attach();
  }

  press(key: PanelKey): void {
    void this.ask("press", { key }).then(() => {
      if (key === "off") this.leave();
    });
  }

  /// Sends a request and reports a refusal; the panel shows the result at once if `acts`.
  async ask<K extends keyof Questions>(what: K, body: Questions[K][0], acts = true): Promise<Questions[K][1] | null> {
    if (!this.client) return null;
    try {
      const answer = this.client.ask(what, body);
      if (acts) {
        // the state is requested after it: questions are answered in order
        this.acted_at = performance.now();
        this.settles ||= what === "enter" || what === "undo";
        if (what === "press") this.on_press.emit();
        void this.look();
      }
      const done = await answer;
      if ("queued" in done) this.on_queued.emit();
      return done;
    } catch (e) {
      if (!(e instanceof Lost)) this.on_error.emit(e instanceof Error ? e.message : String(e));
      return null;
    }
  }

  private async line_changed(line: LineState): Promise<void> {
    if (line === "open") return this.attach();
    if (line === "lost") {
      this.panel = null;
      this.on_panel.emit(null);
    }
  }

  private async attach(): Promise<void> {
    if (!this.question) return;
    const on = await this.ask("machine", this.question, false);
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
    if (!this.client || !this.question) return;
    clearTimeout(this.timer);
    // Nobody looks at a hidden page: a real machine is then held, because it hears nothing of the page.
    if (this.panel?.real && typeof document !== "undefined" && document.hidden) return this.look_soon(standing);
    this.looks++;
    try {
      const panel = await this.client.ask("panel", {}),
        before = this.panel;
      if (!this.question) return void this.looks--; // switched off meanwhile
      this.panel = panel;
      this.on_panel.emit(panel);
      const { mode, takes_tables } = panel,
        stands = mode !== "running" && !takes_tables;
      if (before && stands && (this.settles || before.mode !== mode || before.takes_tables !== takes_tables)) {
        this.settles = false;
        this.on_stood.emit();
      }
      if (mode === "running") this.stood = null;
      await drawn();
    } catch (e) {
      if (!(e instanceof Lost)) this.leave(); // off; a lost connection restores itself
    }
    if (--this.looks > 0 || !this.panel) return;
    this.look_soon(
      performance.now() - this.acted_at < act_lasts ? after_act : this.panel.mode === "running" ? moving : standing,
    );
  }
}
