// What the page knows: what is open, the results of the run, the position of the slider; the signals that tell of
// changes.
import { Lost, type Client, type LineState } from "../protocol/client";
import type { OfPathFrame, PartFrame } from "../protocol/frames";
import type {
  CutResult,
  Done,
  Finding,
  Hello,
  JsonTable,
  Mark,
  Opened,
  PartAnswer,
  Problem,
  Progress,
  State,
} from "../protocol/types";
import { PathIndex } from "./path_index";
import { Signal } from "./signal";
import { Unsaved } from "./unsaved";

export type Choice = { control?: string; machine?: string; setup?: string };

export abstract class AppState {
  abstract readonly client: Client;
  hello: Hello | null = null;
  opened: Opened | null = null;
  choice: Choice = {};
  tables: { file: string; edited: JsonTable } | null = null; // of the machine of that program: laid over its set-up
  text: string | null = null; // as edited; null if the page does not hold the file
  saved_text: string | null = null;
  ran: string | null = null; // the text that the session has run: path, state and sheet belong to it
  cut_text: string | null = null; // the text that was cut: the findings belong to it
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

  get seconds(): number {
    return this.done?.seconds ?? Math.max(this.progress?.seconds ?? 0, this.path.seconds);
  }
  get marks(): Mark[] {
    return [...(this.done?.marks ?? []), ...(this.cut?.marks ?? [])];
  }
  get dirty(): boolean {
    return this.text !== null && this.text !== this.saved_text;
  }

  tell(e: unknown): void {
    if (!(e instanceof Lost)) this.on_error.emit(e instanceof Error ? e.message : String(e)); // a lost connection has its own banner
  }
}
