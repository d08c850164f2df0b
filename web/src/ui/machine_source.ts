// Marks the line that a machine executes, in the text that it runs: in the editor if that is the same text, else in
// its own text, which is shown when it starts. An edit or a save while it is on never moves the mark to another block.
import type { App } from "../model/app";
import type { Operator } from "../model/operator";
import type { SourcePane } from "../source/pane";

export class MachineSource {
  private line = 0; // the marked line
  private held: { digest: string; text: string } | null = null;
  private was_running = false;
  private was_same = true;

  constructor(
    private app: App,
    private operator: Operator,
    private source: SourcePane,
  ) {
    for (const s of [app.on_dirty, app.on_opened, app.on_text]) s.on(() => this.look());
    operator.on_panel.on(() => this.look());
  }

  /// True if the machine belongs to the program on the screen.
  get here(): boolean {
    return Boolean(this.operator.panel) && this.app.opened?.file === this.operator.name;
  }
  /// True if it also runs the shown text.
  get same(): boolean {
    return this.here && !this.app.dirty && this.operator.panel!.digest === this.app.digest;
  }

  private look(): void {
    const p = this.operator.panel,
      { source } = this;
    if (!p || !this.here) {
      source.tell_machine(null);
      source.show_machine(null);
      ((this.line = 0), (this.was_running = false), (this.was_same = true));
      return;
    }
    const starts = p.mode === "running" && !this.was_running,
      { same } = this;
    this.was_running = p.mode === "running";
    if (same !== this.was_same) this.line = 0;
    if (same) {
      source.show_machine(null);
      source.tell_machine(null);
    } else {
      if (this.was_same && !source.shows_machine) source.mark_machine(0);
      source.tell_machine(() => void this.show());
      if (starts && !source.shows_machine) void this.show();
    }
    this.was_same = same;
    if ((same || source.shows_machine) && p.file === 0 && p.line !== this.line) this.mark(p.line);
  }

  private mark(line: number): void {
    this.line = line;
    if (this.source.shows_machine) this.source.mark_machine(line);
    else this.source.show(line);
  }

  private async show(): Promise<void> {
    const { operator } = this,
      digest = operator.panel?.digest;
    if (this.held?.digest !== digest) this.held = await operator.ask("machine_source", {}, false);
    if (!this.held || !this.here || this.same) return; // reported already, or ended meanwhile
    this.source.show_machine(this.held.text);
    this.line = 0;
    this.look();
  }
}
