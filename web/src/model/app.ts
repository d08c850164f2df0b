// The state of the page: what is open, the results of the run, the position of the slider. Panes listen to its signals
// and call its methods.
import { Client, Lost, type LineState, type Socket } from "../protocol/client";
import type { Frame, OfPathFrame, PartFrame } from "../protocol/frames";
import type {
  CutQuestion,
  CutResult,
  Done,
  Finding,
  Hello,
  JsonTable,
  Language,
  Mark,
  OpenQuestion,
  Opened,
  PartAnswer,
  Problem,
  Progress,
  State,
} from "../protocol/types";
import { greet } from "./greet";
import { has_texts } from "./has_texts";
import { Latest, debounce, spaced } from "./latest";
import { remember, remembered } from "./memory";
import { PathIndex } from "./path_index";
import { Signal } from "./signal";
import { clamp } from "./time";
import { take_program_unit } from "./units";
import { Unsaved, type KeptText } from "./unsaved";

const longest_without_part = 1500; // ms during play: a part may take a second, and states wait for it
const most_problems = 10_000; // more than anybody reads; the rest repeats

export type Choice = { control?: string; machine?: string; setup?: string };

export class App {
  readonly client: Client;
  hello: Hello | null = null;
  opened: Opened | null = null;
  choice: Choice = {};
  tables: { file: string; edited: JsonTable } | null = null; // of the machine of that program: laid over its set-up
  text: string | null = null; // as edited; null if the page does not hold the file
  saved_text: string | null = null;
  ran: string | null = null; // the text that the session has run: path, state and sheet belong to it
  digest: string | null = null; // of the file on the disk: saving names the version that it replaces
  running = false;
  progress: Progress | null = null;
  done: Done | null = null;
  instant = 0;
  state: State | null = null;
  problems: Problem[] = []; // of the run
  checked: Problem[] | null = null; // of the current text in the editor
  findings: Finding[] = [];
  cut: CutResult | null = null;
  cutting = false;
  cut_ready = false;
  path = new PathIndex();

  readonly on_line = new Signal<LineState>();
  readonly on_opening = new Signal<string>(); // the requested file
  readonly on_opened = new Signal<Opened>();
  readonly on_run = new Signal<void>(); // progress, done, running
  readonly on_done = new Signal<Done>();
  readonly on_instant = new Signal<number>();
  readonly on_state = new Signal<State | null>();
  readonly on_problems = new Signal<void>();
  readonly on_path = new Signal<OfPathFrame>();
  readonly on_part = new Signal<PartFrame | null>();
  readonly on_part_told = new Signal<PartAnswer | null>();
  readonly on_cut = new Signal<number | null>(); // part done, null: something else of the cut changed
  readonly on_text = new Signal<void>();
  readonly on_error = new Signal<string>();
  readonly on_dirty = new Signal<boolean>();
  readonly on_files = new Signal<string>(); // a new file has been saved
  readonly unsaved = new Unsaved();

  private wanted = remembered<{ question: OpenQuestion; at: number } | null>("open", null, "tab");
  private last_cut: CutQuestion | null = null;
  private wishes = 0; // requests for another instant: the last one counts, however late an answer comes
  private states = new Latest<{ at: number } | { number: number }>((w) => this.fetch_state(w));
  private parts = new Latest<number>((at) => this.fetch_part(at));
  private want_part = debounce(
    120,
    () => {
      if (this.cut_ready) this.parts.want(this.instant);
    },
    longest_without_part,
  );
  // A program may cause thousands of warnings in a second: the panes draw a few times a second at most.
  private tell_problems = spaced(100, () => this.on_problems.emit());
  private tell_findings = spaced(100, () => this.on_cut.emit(null));
  private keep = debounce(300, () => this.keep_place());
  private recut = false; // a part that existed before the connection was lost is cut once more
  private opening = 0; // questions `open` without an answer: messages meanwhile belong to an older program
  private target = 0; // the block that stepping aims at, while answers are pending

  constructor(make: () => Socket) {
    this.client = new Client(make, (c) => this.greet(c));
    this.client.line.on((l) => void this.line_changed(l));
    this.client.frame.on((f) => this.take_frame(f));
    this.client.event.on((e) => {
      if (e.name === "closed") return this.on_error.emit(e.body.text);
      if (this.opening) return;
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
    });
  }

  get seconds(): number {
    return this.done?.seconds ?? Math.max(this.progress?.seconds ?? 0, this.path.seconds);
  }
  get marks(): Mark[] {
    return [...(this.done?.marks ?? []), ...(this.cut?.marks ?? [])];
  }
  get dirty(): boolean {
    return this.text !== null && this.text !== this.saved_text;
  }

  async open(question: OpenQuestion, at = 0): Promise<void> {
    const before = this.opened;
    this.forget_run();
    this.opened = null;
    this.on_opening.emit(question.file);
    this.wanted = { question, at };
    this.running = true;
    this.on_run.emit();
    this.opening++;
    try {
      const opened = await this.client.ask("open", question).finally(() => {
        this.opening--;
      });
      if (this.opening) return; // another one was requested meanwhile
      this.choice = { control: question.control, machine: question.machine, setup: question.setup };
      this.opened = opened;
      if (question.text === undefined) this.found_on_disk(opened);
      this.text = this.ran = question.text ?? opened.text ?? null;
      this.keep_place();
      this.on_opened.emit(opened);
      this.on_dirty.emit(this.dirty);
      if (this.text !== null && !this.dirty) this.unsaved.offer(opened.file, this.text);
    } catch (e) {
      if (this.opening) return;
      this.running = false;
      this.on_run.emit();
      this.tell(e);
      const { control, machine, setup } = this.choice; // with which it could be opened
      if (
        before?.file === question.file &&
        (question.control !== control || question.machine !== machine || question.setup !== setup)
      )
        await this.open({ ...question, control, machine, setup }, at);
    }
  }

  /// Runs the current text of the editor, saved or not, with these choices.
  async run_again(choice: Choice = this.choice): Promise<void> {
    if (!this.opened) return;
    const question: OpenQuestion = { file: this.opened.file, ...choice };
    if (this.tables?.file === this.opened.file && Object.keys(this.tables.edited).length)
      question.tables = this.tables.edited;
    if (this.dirty && this.text !== null) question.text = this.text;
    await this.open(question, this.instant);
  }

  /// Questions to the session are about the text that it has run: if the editor's text differs, it is run first.
  /// Returns false if it cannot be opened, which has been reported.
  async run_shown(): Promise<boolean> {
    if (this.text !== this.ran) await this.run_again();
    return this.opened !== null;
  }

  stop(): void {
    this.client.ask("stop", {}).catch((e) => this.tell(e));
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

  async run_cut(question: CutQuestion): Promise<void> {
    if (!(await this.run_shown())) return;
    this.last_cut = question;
    this.findings = [];
    this.cut = null;
    this.cut_ready = false;
    this.cutting = true;
    this.on_part.emit(null);
    this.on_cut.emit(0);
    try {
      await this.client.ask("cut", question);
    } catch (e) {
      this.cutting = false;
      this.on_cut.emit(null);
      this.tell(e);
    }
  }

  set_text(text: string): void {
    const before = this.dirty;
    this.text = text;
    this.on_text.emit();
    this.keep();
    if (before !== this.dirty) this.on_dirty.emit(this.dirty);
  }
  /// `digest` of the file as it is on the disk now.
  saved(text: string, digest: string): void {
    this.digest = digest;
    this.saved_text = text;
    this.on_dirty.emit(this.dirty);
  }

  async speak(lang: Language): Promise<void> {
    try {
      await this.client.ask("language", { lang });
      await this.greet(this.client); // names of controls
      if (!this.opened) return this.on_line.emit("open");
      if (!has_texts(this)) {
        this.on_opened.emit(this.opened); // no message of the run is in the other language
        return this.states.want({ at: this.instant });
      }
      this.recut = this.cut_ready;
      await this.run_again();
    } catch (e) {
      this.tell(e);
    }
  }

  tell(e: unknown): void {
    if (!(e instanceof Lost)) this.on_error.emit(e instanceof Error ? e.message : String(e)); // a lost connection has its own banner
  }

  private async greet(client: Client): Promise<void> {
    this.hello = await greet(client);
    this.unsaved.of_folder(this.hello.folder);
  }

  private async line_changed(line: LineState): Promise<void> {
    if (line === "lost") {
      this.recut ||= this.cut_ready || this.cutting;
      this.running = this.cutting = this.cut_ready = false;
      this.on_run.emit();
    }
    this.on_line.emit(line);
    if (line !== "open") return;
    const again = this.wanted;
    const file = again?.question.file ?? this.hello?.last;
    if (!file) return;
    const question: OpenQuestion = again ? { ...again.question } : { file };
    const mine = this.dirty && this.opened?.file === file ? { text: this.text!, digest: this.digest } : null,
      unsaved = mine ?? this.unsaved.own(file); // a text for which the browser has no room is still here
    if (unsaved) return this.reopen_unsaved(question, unsaved, again?.at ?? 0);
    delete question.text;
    await this.open(question, again?.at ?? 0);
  }

  /// The edited text is run, but the session opens the file on the disk first: saving must replace only the version
  /// that was edited.
  private async reopen_unsaved(
    question: OpenQuestion,
    kept: Pick<KeptText, "text" | "digest">,
    at: number,
  ): Promise<void> {
    delete question.text;
    try {
      this.found_on_disk(await this.client.ask("open", question));
    } catch (e) {
      return this.tell(e);
    }
    this.digest = kept.digest ?? this.digest;
    await this.open({ ...question, text: kept.text }, at);
  }
  /// Takes over a text of an earlier visit for the open program.
  async take_unsaved(kept: KeptText): Promise<void> {
    this.unsaved.drop(kept);
    await this.reopen_unsaved({ file: kept.file, ...this.choice }, kept, this.instant);
  }

  private found_on_disk(opened: Opened): void {
    this.saved_text = opened.text ?? null;
    this.digest = opened.digest;
  }

  private forget_run(): void {
    this.path.clear();
    this.progress = this.done = this.state = this.cut = this.checked = null;
    this.problems = [];
    this.findings = [];
    this.cutting = this.cut_ready = false;
    this.instant = 0;
    this.on_part.emit(null);
    this.on_state.emit(null);
    this.on_problems.emit();
    this.on_cut.emit(null);
  }

  private take_frame(frame: Frame): void {
    if (this.opening) return;
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
    this.seek(this.wanted?.at ?? 0);
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

  private move_to(at: number): void {
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

  /// Runs at once: the page is about to close.
  keep_place(): void {
    if (!this.opened || !this.wanted) return;
    const { text: _, ...question } = this.wanted.question;
    this.wanted = { question, at: this.done ? this.instant : this.wanted.at }; // until the run is complete, the old position is still the target
    remember("open", this.wanted, "tab");
    this.unsaved.keep(this.opened.file, this.dirty ? this.text : null, this.digest);
  }
}
