// What a run and a cut have found, as the session's messages tell it.
import type { SessionEvent } from "../protocol/messages";
import { Refused } from "../protocol/client";
import type { Frame } from "../protocol/frames";
import type { CutQuestion, CutResult, Done } from "../protocol/types";
import { AppTime } from "./app_time";
import { spaced } from "./latest";
import { take_program_unit } from "./units";

const most_problems = 10_000; // more than anybody reads; the rest repeats

export abstract class AppResults extends AppTime {
  private last_cut: CutQuestion | null = null;
  protected recut = false; // a part that existed before the connection was lost, or that a run has ended, is cut once more
  // A program may cause thousands of warnings in a second: the panes draw a few times a second at most.
  private tell_problems = spaced(100, () => this.on_problems.emit());
  private tell_findings = spaced(100, () => this.on_cut.emit(null));

  /// Runs the text that is shown, if another one was run.
  abstract run_shown(): Promise<boolean>;
  /// The instant at which the slider stands when the run is complete.
  protected abstract wanted_at(): number;

  /// Returns why the cut was refused, which has been reported; "" if it has begun.
  async run_cut(question: CutQuestion): Promise<string> {
    if (!(await this.run_shown())) return "";
    this.last_cut = question;
    this.cut_text = this.ran;
    this.findings = [];
    this.cut = null;
    this.cut_ready = false;
    this.cutting = true;
    this.on_part.emit(null);
    this.on_cut.emit(0);
    try {
      await this.client.ask("cut", question);
      return "";
    } catch (e) {
      this.cutting = false;
      this.on_cut.emit(null);
      this.tell(e);
      return e instanceof Refused ? e.message : "";
    }
  }

  protected take_event(e: SessionEvent): void {
    if (e.name === "progress") {
      this.progress = e.body;
      this.on_run.emit();
    } else if (e.name === "alarm") {
      if (this.problems.push({ ...e.body.problem, at: e.body.at }) > most_problems) this.problems.pop();
      this.tell_problems();
    } else if (e.name === "done") this.take_done(e.body);
    else if (e.name === "cutting") this.on_cut.emit(e.body.part);
    else if (e.name === "finding") {
      if (this.findings.push(e.body) > most_problems) this.findings.pop();
      this.tell_findings();
    } else if (e.name === "cut") this.take_cut(e.body);
  }

  /// `live`: what is shown stays until the results of the next run replace it, and what the cut has found stays until the
  /// next cut; only the part is gone.
  protected forget_run(live = false): void {
    this.path.clear();
    this.progress = this.cut = null;
    this.problems = [];
    if (live) this.recut ||= this.cutting;
    else this.findings = [];
    this.cutting = this.cut_ready = false;
    this.on_part.emit(null);
    this.on_cut.emit(null);
    if (live) return;
    this.done = this.state = this.checked = null;
    this.instant = 0;
    this.on_state.emit(null);
    this.on_problems.emit();
  }

  protected take_frame(frame: Frame): void {
    if (frame.kind === "part") return this.on_part.emit(frame);
    if (frame.kind === "path") this.path.add(frame);
    this.on_path.emit(frame);
  }

  private take_done(done: Done): void {
    this.done = done;
    this.running = false;
    take_program_unit(this.opened?.file ?? "", done.units);
    this.on_done.emit(done);
    this.on_run.emit();
    this.on_problems.emit();
    this.seek(this.wanted_at());
    if (this.last_cut && this.opened && this.recut) void this.run_cut(this.last_cut);
    this.recut = false;
  }

  private take_cut(result: CutResult): void {
    this.cut = result;
    this.cutting = false;
    this.cut_ready = !result.error;
    if (result.error) this.on_error.emit(result.error.text);
    this.on_cut.emit(null);
    this.want_part();
  }
}
