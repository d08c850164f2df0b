// Axes moved by hand. A held key moves its axis as long as the page says so ten times a second: the machine stops by
// itself when it hears nothing, whatever has happened to the page. Steps add up, none is lost.
import type { Operator } from "./operator";

export const renew_every = 100; // ms
const most_waiting = 50; // steps

/// The state at hand is older than a motion that has just been accepted: it says that the machine stands. Only the first
/// state after the answer counts, as questions are answered in order.
class Shown {
  is = true;
  private answered = true;

  ask(): void {
    this.is = this.answered = false;
  }
  answer(accepted: boolean): void {
    this.answered = true;
    if (!accepted) this.is = true;
  }
  state(): void {
    if (this.answered) this.is = true;
  }
}

interface Held {
  axis: string;
  way: 1 | -1;
  feed: number;
  channel: number;
}

export class HeldJog {
  private held: Held | null = null; // the key that is held
  private moves = false; // a request to move has been sent
  private shown = new Shown(); // whether a state shows that motion
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor(private operator: Operator) {
    operator.on_panel.on(() => {
      this.shown.state();
      this.begin();
    });
  }

  /// True while the axes move because of a key, or a key is held.
  get busy(): boolean {
    return this.moves || this.held !== null;
  }

  /// Begins to move an axis; `feed` mm/min or degrees/min, 0: as fast as possible. If the axes still slow down after an
  /// earlier key, it begins when they stand, if the key is still held then.
  press(axis: string, way: 1 | -1, feed: number, channel = 0): void {
    this.release();
    this.held = { axis, way, feed, channel };
    this.begin();
  }
  /// The axis slows down and stops.
  release(): void {
    this.held = null;
    if (this.timer === undefined) return;
    this.end();
    void this.operator.ask("jogging", { on: false });
  }

  private begin(): void {
    const p = this.operator.panel,
      { held } = this;
    if (this.timer !== undefined) return;
    if (p && this.moves && this.shown.is && p.mode !== "running") this.moves = false;
    if (!held || !p || this.moves) return;
    if (!p.holds || !["standing", "ended"].includes(p.mode)) {
      this.held = null; // a program runs, or an alarm: a key that is held must not begin later
      return;
    }
    const { axis, way, feed, channel } = held;
    const timer = setInterval(() => void this.renew(timer), renew_every);
    this.timer = timer;
    this.moves = true;
    this.shown.ask();
    void this.operator.ask("jog", { axis, way, feed, held: true, ...(channel ? { channel } : {}) }).then((answer) => {
      this.shown.answer(answer !== null);
      if (!answer) this.fail(timer);
    });
  }

  private async renew(timer: typeof this.timer): Promise<void> {
    const answer = await this.operator.ask("jogging", { on: true }, false);
    if (!answer?.moves) this.fail(timer); // the end of the travel, a hold, a lost connection
  }

  private fail(timer: typeof this.timer): void {
    if (this.timer !== timer) return;
    this.held = null;
    this.end();
  }
  private end(): void {
    clearInterval(this.timer);
    this.timer = undefined;
  }
}

/// Steps of one axis after the other; those that come while an axis moves are made when it stands.
export class StepJog {
  private waiting = new Map<string, { axis: string; channel: number; steps: number; size: number; feed: number }>();
  private asking = false;
  private moving = false; // the axes move because of a step
  private shown = new Shown(); // whether a state shows that motion

  constructor(private operator: Operator) {
    operator.on_panel.on(() => {
      this.shown.state();
      this.go_on();
    });
  }

  /// True while steps may be added: the machine stands, or moves because of a step. A step that is asked for while a
  /// program runs must not be made when it ends.
  get takes(): boolean {
    const p = this.operator.panel;
    return Boolean(p?.holds) && (["standing", "ended"].includes(p!.mode) || (p!.mode === "running" && this.busy));
  }
  private get busy(): boolean {
    return this.asking || this.moving;
  }

  /// `size` mm or degrees of one step, as the machine moves; `steps` signed.
  step(axis: string, steps: number, size: number, feed: number, channel = 0): void {
    if (!this.takes) return;
    const key = `${channel}:${axis}`,
      before = this.waiting.get(key);
    const sum = before?.size === size ? before.steps + steps : steps;
    this.waiting.set(key, {
      axis,
      channel,
      size,
      feed,
      steps: Math.min(most_waiting, Math.max(-most_waiting, sum)),
    });
    this.go_on();
  }
  /// Forgets the steps that have not begun.
  clear(): void {
    this.waiting.clear();
  }

  private go_on(): void {
    const p = this.operator.panel;
    if (this.asking || !this.shown.is) return;
    if (!this.takes) {
      this.moving = false;
      return this.clear();
    }
    if (p!.mode === "running") return;
    this.moving = false;
    if (!this.waiting.size) return;
    const [key, { axis, channel, steps, size, feed }] = this.waiting.entries().next().value!;
    this.waiting.delete(key);
    if (!steps) return this.go_on();
    this.asking = true;
    this.shown.ask();
    const way = Math.round(steps * size * 1e6) / 1e6;
    void this.operator.ask("jog", { axis, way, feed, ...(channel ? { channel } : {}) }).then((answer) => {
      this.asking = false;
      this.shown.answer(answer !== null);
      this.moving = answer !== null;
      if (!answer) this.clear();
    });
  }
}
