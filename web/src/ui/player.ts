// Plays the program at 0.1 to 1000 times the machine's speed, over a selection in a loop if there is one.
import type { App } from "../model/app";
import { played } from "../model/time";
import { Signal } from "../model/signal";

export class Player {
  readonly changed = new Signal<void>();
  playing = false;
  times = 1;
  loop: [number, number] | null = null;
  private last = 0;

  constructor(private app: App) {
    app.on_opening.on(() => {
      this.loop = null;
      this.stop();
    });
  }

  toggle(): void {
    if (this.playing) this.stop();
    else this.start();
  }
  stop(): void {
    this.playing = false;
    this.changed.emit();
  }
  set_times(times: number): void {
    this.times = times;
    this.changed.emit();
  }
  set_loop(loop: [number, number] | null): void {
    this.loop = loop;
    this.changed.emit();
  }

  private start(): void {
    const { app } = this;
    if (!app.done || app.seconds <= 0) return;
    if (app.instant >= app.seconds) app.seek(0);
    this.playing = true;
    this.last = performance.now();
    this.changed.emit();
    requestAnimationFrame((now) => this.frame(now));
  }

  private frame(now: number): void {
    if (!this.playing) return;
    const { app } = this;
    const at = played(app.instant, Math.max(0, now - this.last), this.times, app.seconds, this.loop);
    this.last = now;
    app.seek(at);
    if (!this.loop && at >= app.seconds) return this.stop();
    requestAnimationFrame((next) => this.frame(next));
  }
}
