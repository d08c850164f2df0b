// The path follows the text: a short time after the last key the text is run, and a run of an older text is cancelled.
import type { App } from "./app";
import { debounce } from "./latest";
import { Signal } from "./signal";

const quiet = 350; // ms after the last key
const least_rest = 0.5; // of the time that the last run took: a long program does not run all the time while one types

export class Live {
  readonly on_old = new Signal<boolean>(); // whether the path that is shown belongs to an older text
  old = false;
  private began = 0;
  private took = 0; // ms of the last complete run
  private timer: ReturnType<typeof setTimeout> | undefined;
  private tell_soon = debounce(150, () => this.tell());

  constructor(private app: App) {
    app.on_text.on(() => this.changed());
    app.on_opening.on(() => (this.began = performance.now()));
    app.on_done.on(() => {
      this.took = performance.now() - this.began;
      this.tell();
    });
    app.on_opened.on(() => this.tell_soon());
  }

  private changed(): void {
    this.tell_soon();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.app.follow_text(), Math.max(quiet, Math.min(2000, least_rest * this.took)));
  }

  private tell(): void {
    const { app } = this,
      old = app.opened !== null && (app.text !== app.ran || app.running);
    if (old === this.old) return;
    this.old = old;
    this.on_old.emit(old);
  }
}
