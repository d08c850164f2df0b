// The app of the page: opens, runs and keeps programs. Panes listen to its signals and call its methods; what it knows is
// in app_state.ts, app_time.ts and app_results.ts.
import { Client, type LineState, type Socket } from "../protocol/client";
import type { Language, OpenQuestion, Opened } from "../protocol/types";
import { AppResults } from "./app_results";
import type { Choice } from "./app_state";
import { greet } from "./greet";
import { has_texts } from "./has_texts";
import { debounce } from "./latest";
import { remember, remembered } from "./memory";
import type { KeptText } from "./unsaved";

export type { Choice };

export class App extends AppResults {
  readonly client: Client;
  private wanted: { question: OpenQuestion; at: number } | null;
  private keep_soon = debounce(300, () => this.keep_place());
  private opening = 0; // questions `open` without an answer: messages meanwhile belong to an older program

  /// `given`: the program to open first, of files that came with the page; null: the one that this tab had open.
  constructor(
    make: () => Socket,
    private given: OpenQuestion | null = null,
  ) {
    super();
    this.wanted = remembered(this.place(), given && { question: given, at: 0 }, "tab");
    this.client = new Client(make, (c) => this.greet(c));
    this.client.line.on((l) => void this.line_changed(l));
    this.client.frame.on((f) => {
      if (!this.opening) this.take_frame(f);
    });
    this.client.event.on((e) => {
      if (e.name === "closed") return this.on_error.emit(e.body.text);
      if (!this.opening) this.take_event(e);
    });
  }

  /// `live`: the same program runs again because its text has changed: what is shown stays until the new run replaces it.
  async open(question: OpenQuestion, at = 0, live = false): Promise<void> {
    const before = this.opened,
      shown = this.text;
    this.forget_run(live);
    if (!live) this.opened = null;
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
      this.ran = question.text ?? opened.text ?? null;
      // What was typed while the session opened the same program is newer than what it opened.
      if (before?.file !== question.file || this.text === shown) this.text = this.ran;
      this.keep_place();
      this.on_opened.emit(opened);
      this.on_dirty.emit(this.dirty);
      if (this.text !== null && !this.dirty) this.unsaved.offer(opened.file, this.text);
    } catch (e) {
      if (this.opening) return;
      this.running = false;
      this.on_run.emit();
      if (live) return; // the view says that it is old; the problems of the text say why
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
  async run_again(choice: Choice = this.choice, live = false): Promise<void> {
    if (!this.opened) return;
    const question: OpenQuestion = { file: this.opened.file, ...choice };
    if (this.tables?.file === this.opened.file && Object.keys(this.tables.edited).length)
      question.tables = this.tables.edited;
    if (this.dirty && this.text !== null) question.text = this.text;
    await this.open(question, this.done ? this.instant : (this.wanted?.at ?? this.instant), live);
  }
  /// Runs the text as it is now; a run of an older text is cancelled.
  async follow_text(): Promise<void> {
    if (!this.opened || this.text === this.ran || !this.opened.editable) return;
    if (this.running) this.stop();
    await this.run_again(this.choice, true);
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

  set_text(text: string): void {
    const before = this.dirty;
    this.text = text;
    this.on_text.emit();
    this.keep_soon();
    if (before !== this.dirty) this.on_dirty.emit(this.dirty);
  }
  /// `digest` of the file as it is on the disk now.
  saved(text: string, digest: string): void {
    this.digest = digest;
    this.saved_text = text;
    this.on_dirty.emit(this.dirty);
  }

  /// The open program has another name on the disk now; what is not saved goes with it.
  async renamed(to: string): Promise<void> {
    if (!this.opened || !this.wanted) return;
    this.unsaved.rename(this.opened.file, to);
    this.opened.file = to;
    await this.run_again();
  }
  /// Another page or program has changed the file. `take`: the text of the disk replaces the one of the page; else the
  /// next save replaces the file.
  async changed_on_disk(on_disk: { text: string; digest: string }, take: boolean): Promise<void> {
    if (take) this.text = on_disk.text;
    this.saved(on_disk.text, on_disk.digest);
    this.keep_place();
    if (take) await this.run_again();
  }
  /// The file is not on the disk any more: the text of the page is the only one, and saving creates the file again.
  lost_on_disk(): void {
    this.digest = this.saved_text = null;
    this.on_dirty.emit(this.dirty);
    this.keep_place();
  }

  async speak(lang: Language): Promise<void> {
    try {
      await this.client.ask("language", { lang });
      await this.greet(this.client); // names of controls
      if (!this.opened) return this.on_line.emit("open");
      if (!has_texts(this)) {
        this.on_opened.emit(this.opened); // no message of the run is in the other language
        return this.want_state();
      }
      this.recut = this.cut_ready;
      await this.run_again();
    } catch (e) {
      this.tell(e);
    }
  }

  protected keep(): void {
    this.keep_soon();
  }
  protected wanted_at(): number {
    return this.wanted?.at ?? 0;
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

  /// Where the tab remembers what is open: files that came with a page are not those of another page in the same tab.
  private place(): string {
    return this.given ? `open ${this.given.file}` : "open";
  }
  /// Runs at once: the page is about to close.
  keep_place(): void {
    if (!this.opened || !this.wanted) return;
    const { text: _, ...question } = this.wanted.question;
    this.wanted = { question, at: this.done ? this.instant : this.wanted.at }; // until the run is complete, the old position is still the target
    remember(this.place(), this.wanted, "tab");
    this.unsaved.keep(this.opened.file, this.dirty ? this.text : null, this.digest);
  }
}
