// The instant that is shown: the slider, steps by blocks, the state and the part at that instant.
import { AppState } from "./app_state";
import { Latest, debounce } from "./latest";
import { clamp } from "./time";

const longest_without_part = 1500; // ms during play: a part may take a second, and states wait for it

export abstract class AppTime extends AppState {
  private wishes = 0; // requests for another instant: the last one counts, however late an answer comes
  private states = new Latest<{ at: number } | { number: number }>((w) => this.fetch_state(w));
  private parts = new Latest<number>((at) => this.fetch_part(at));
  protected want_part = debounce(
    120,
    () => {
      if (this.cut_ready) this.parts.want(this.instant);
    },
    longest_without_part,
  );
  private target = 0; // the block that stepping aims at, while answers are pending

  protected abstract keep(): void; // of the slider for a reload, soon
  protected want_state(): void {
    this.states.want({ at: this.instant });
  }

  seek(at: number): void {
    this.wishes++;
    this.target = 0;
    this.move_to(clamp(at, 0, this.seconds));
    this.states.want({ at: this.instant });
  }

  /// Goes to a block by its number in the run; the instant comes with the answer.
  seek_block(number: number): void {
    const last = this.done?.blocks ?? Infinity;
    this.wishes++;
    this.target = clamp(number, 1, last);
    this.states.want({ number: this.target });
  }
  /// Goes to the pass of a line that is nearest to the slider.
  async seek_line(line: number, file: number): Promise<void> {
    const wish = ++this.wishes;
    try {
      const { passes } = await this.client.ask("passes", file ? { line, file } : { line });
      const off = (p: { from: number; to: number }): number =>
        this.instant < p.from ? p.from - this.instant : this.instant > p.to ? this.instant - p.to : 0;
      const nearest = passes.reduce<(typeof passes)[0] | null>(
        (best, p) => (!best || off(p) < off(best) ? p : best),
        null,
      );
      if (nearest && wish === this.wishes) this.seek_block(nearest.number);
    } catch (e) {
      this.tell(e);
    }
  }
  step(blocks: number): void {
    const told = this.state?.at === this.instant ? this.state.number : this.path.number_at(this.instant); // the last state may be of another instant
    const here = this.target || told;
    this.seek_block(here + blocks);
  }

  protected move_to(at: number): void {
    this.instant = at;
    this.on_instant.emit(at);
    this.want_part();
    this.keep();
  }

  private async fetch_state(wish: { at: number } | { number: number }): Promise<void> {
    const state = await this.client.ask("state", wish);
    const moves = "number" in wish && this.target !== 0; // the slider may have been moved meanwhile
    if (this.states.stale) {
      if (moves) this.move_to(state.at);
      return;
    }
    this.state = state;
    if (moves) this.move_to(state.at);
    this.on_state.emit(state);
  }

  private async fetch_part(at: number): Promise<void> {
    try {
      this.on_part_told.emit(await this.client.ask("part", { at }));
    } catch (e) {
      this.tell(e);
    }
  }
}
