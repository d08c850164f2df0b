// Every message of docs/panel-protocol.md. Units: mm, degrees, seconds, mm/min, rev/min; lines and columns from 1.
import type { JsonTable, Language } from "./types/base";
import type { Compared, CutQuestion, CutResult, Finding, PartAnswer, Proposals, Sheet, Tool } from "./types/cut";
import type { FileQuestions } from "./types/files";
import type {
  ConvertQuestion,
  Converted,
  MillQuestion,
  Milled,
  NotMilled,
  Punched,
  TapeCode,
  TapeRead,
} from "./types/making";
import type { BlocksQuestion, EditQuestion, EditedProgram, WrittenBlocks } from "./types/editing";
import type {
  ChannelWay,
  LogEntry,
  Panel,
  PanelKey,
  PanelMode,
  Proof,
  RestartPlace,
  RestartSheet,
  Stood,
  Tables,
  WayPoint,
} from "./types/panel";
import type { SetupForm } from "./types/setup";
import type {
  Checked,
  Done,
  Explained,
  Files,
  Hello,
  OpenQuestion,
  RealQuestion,
  Opened,
  Outline,
  Passes,
  Problem,
  Progress,
  State,
} from "./types/program";

export type * from "./types/base";
export type * from "./types/files";
export type * from "./types/program";
export type * from "./types/cut";
export type * from "./types/panel";
export type * from "./types/making";
export type * from "./types/setup";
export type * from "./types/editing";

export interface Questions extends FileQuestions {
  hello: [{ token?: string; lang: Language }, Hello];
  language: [{ lang: Language }, object];
  files: [{ folder: string }, Files];
  open: [OpenQuestion, Opened];
  source: [{ from: number; count: number; file?: number }, { lines: string[] }];
  state: [{ at: number } | { number: number }, State];
  passes: [{ line: number; file?: number }, Passes];
  check: [{ text: string }, Checked];
  explain: [{ line: number; text?: string }, Explained];
  outline: [{ text?: string }, Outline];
  cut: [CutQuestion, object];
  part: [{ at: number }, PartAnswer];
  proposals: [{ tools?: string }, Proposals];
  sheet: [object, Sheet];
  report: [object, { html: string; name: string }];
  setup_form: [object, SetupForm];
  keep_tools: [{ file: string; digest: string | null; tools: Tool[] }, { digest: string }];
  keep_setup: [{ file: string; digest: string | null; values: JsonTable }, { digest: string }];
  read: [{ file: string }, { text: string; digest: string; encoding: string }];
  compare: [{ file?: string; text?: string; control?: string; tolerance?: number }, Compared];
  save: [{ file: string; digest: string | null } & ({ text: string } | { bytes: string }), { digest: string }];
  mill: [MillQuestion, Milled | NotMilled];
  tape: [
    (
      | { way: "out"; file: string; text?: string; code?: TapeCode; leader?: number }
      | { way: "in"; file: string; code?: TapeCode }
    ),
    Punched | TapeRead,
  ];
  convert: [ConvertQuestion, Converted];
  edit_program: [EditQuestion, EditedProgram];
  write_blocks: [BlocksQuestion, WrittenBlocks];
  stop: [object, object];
  machines: [object, { machines: { name: string; mode: PanelMode | "kept"; held: boolean }[] }];
  ports: [object, { ports: string[] }];
  prove: [RealQuestion, Proof];
  machine: [
    RealQuestion,
    {
      name: string;
      axes: string[];
      control: string;
      machine: string;
      holds: boolean;
      stood: Stood | null;
      lasts: boolean;
    },
  ];
  panel: [object, Panel];
  machine_source: [object, { text: string; digest: string }];
  press: [{ key: PanelKey }, object];
  switches: [
    {
      single?: boolean;
      optional_stop?: boolean;
      skip?: number;
      on?: boolean;
      override?: number;
      rapid?: number;
      spindle?: number;
      dry_feed?: number;
    },
    object,
  ];
  enter: [{ line: string }, object];
  undo: [object, object];
  jog: [{ axis: string; way: number; feed?: number; channel?: number; held?: boolean }, object];
  probe: [{ axis: string; way: number; feed: number }, object];
  jogging: [{ on: boolean }, { moves: boolean }];
  restart: [
    RestartPlace & { by_control?: boolean; clearance?: number; above?: number; feed?: number },
    RestartSheet | { ready: false },
  ];
  lead: [{ way: WayPoint[] }, object];
  go_there: [RestartPlace & { by_control?: boolean; leave?: string[]; ways: ChannelWay[] }, object];
  tables: [object, Tables];
  edit: [{ tables: JsonTable }, { edited: JsonTable }];
  keep_tables: [{ setup: string }, { digest: string }];
  shift: [{ file?: string; count?: number }, { log: LogEntry[]; lasts: boolean }];
  answer: [{ answer: number }, object];
  watch: [{ expressions: string[] }, { values: { text: string; value: number | null }[] }];
  stops: [
    { line?: number; pass?: number; call?: string; condition?: string; tool?: number; remove?: number },
    { number?: number },
  ];
}

export interface Events {
  progress: Progress;
  alarm: { problem: Problem; at: number };
  done: Done;
  cutting: { part: number };
  finding: Finding;
  cut: CutResult;
  compared: { seconds: number; blocks: number };
  closed: { text: string };
}
