// Every message of docs/panel-protocol.md. Units: mm, degrees, seconds, mm/min, rev/min; lines and columns from 1.
export type Language = "en" | "ru";
export type Box = [number[], number[]];
export type Axes = Record<string, number>;

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type JsonTable = { [key: string]: Json };

export interface Hello {
  version: string;
  folder: string;
  may_change: boolean;
  last: string | null;
  controls: { id: string; name: string }[];
  machines: string[];
}
export interface FileEntry {
  name: string;
  kind: "folder" | "program" | "setup" | "tools" | "other";
  size: number;
  modified: number | string;
}
export interface Files {
  entries: FileEntry[];
  more?: boolean;
}

export interface OpenQuestion {
  file: string;
  control?: string;
  machine?: string;
  setup?: string;
  encoding?: string;
  text?: string;
  tables?: JsonTable;
}
/// Machine coordinates; null: no limit there.
export type Open = (number | null)[];
export interface Bounds {
  limits: [Open, Open];
  zones: { number: number; inside: boolean; box: [Open, Open] }[];
}
export interface Opened {
  file: string;
  size: number;
  digest: string;
  encoding: string;
  control: { id: string; name: string; guessed: boolean; lathe?: boolean; decisive?: boolean | string; why?: string };
  machine: string | null;
  setup: string | null;
  editable: boolean;
  lines: number;
  text?: string;
  bounds?: Bounds;
}

export type Severity = "alarm" | "warning" | "advice" | "note";
export interface Fix {
  text: string;
  line: number;
  from: number;
  to: number;
  insert: string;
}
export interface Problem {
  id: string;
  severity: Severity;
  number?: number | string;
  text: string;
  hint?: string;
  file?: string | number;
  line: number;
  column?: number;
  end_column?: number;
  block?: string;
  calls?: string[];
  fix?: Fix;
  at?: number;
}
export interface Checked {
  problems: Problem[];
}
export interface Word {
  from: number;
  to: number;
  code: string;
  title: string;
  text: string;
}
export interface Explained {
  words: Word[];
}

export interface Call {
  what: string;
  line: number;
  block?: string;
  file?: number | string;
}
export interface Modal {
  group: string;
  code: string;
  changed?: boolean;
}
export interface Variable {
  name: string;
  value: number | string | null;
  changed?: boolean;
}
/// Constant surface speed: m/min, and the highest speed of the spindle that the program permits, rev/min.
export interface Surface {
  speed: number;
  most: number | null;
}
/// The row of a lathe's offset table that is in force: true lengths in mm, tip by its number.
export interface ToolOffset {
  row: number;
  geometry: Axes;
  wear: Axes;
  radius: number;
  tip: number;
}
export interface State {
  at: number;
  number: number;
  line: number;
  column?: number;
  file?: number;
  file_name?: string;
  block?: string;
  text?: string;
  pass?: number;
  depth?: number;
  calls?: Call[];
  position: Axes;
  machine: Axes;
  togo: Axes;
  feed: number;
  speed: number;
  rpm: number | null;
  tool: number;
  modal: Modal[];
  offsets: { T?: number; D?: number; H?: number; radius?: number; length?: Axes };
  zero: Axes;
  diameters?: string[];
  feed_per_turn?: number | null;
  surface?: Surface | null;
  tool_offset?: ToolOffset | null;
  variables: Variable[];
  limits?: string | null;
  seconds: number;
  left: number;
}
export interface Pass {
  from: number;
  to: number;
  number: number;
}
export interface Passes {
  passes: Pass[];
  count: number;
}

export type MarkKind = "tool" | "alarm" | "warning" | "stop" | "optional_stop" | "message" | "zero" | "dwell" | "end";
export interface Mark {
  at: number;
  kind: MarkKind;
  line: number;
  text: string;
}
export interface ToolTime {
  tool: number;
  from: number;
  seconds: number;
  name?: string;
  radius?: number;
  length?: number;
}
/// A joint that moves the part, in the order from the bed to the part: rotates right-handed about the line through
/// `through`, or moves along it; drawn as it is at `from`.
export interface Joint {
  axis: string;
  turns: boolean;
  direction: [number, number, number];
  through: [number, number, number];
  from: number;
}
export interface Done {
  state: "ended" | "stopped" | "cancelled";
  seconds: number;
  blocks: number;
  vertices: number;
  zero: [number, number, number];
  joints: Joint[];
  extents: { cutting: Box | null; all: Box | null };
  distances: { cutting: number; rapid: number };
  times: { cutting: number; rapid: number; dwell: number; tools: number };
  tools: ToolTime[];
  marks: Mark[];
  axes: string[];
  diameters?: string[];
  units: "mm" | "inch";
  unstated?: string;
}
export interface Progress {
  part: number;
  blocks: number;
  seconds: number;
}

export interface Tool {
  number: number;
  kind: string;
  diameter?: number;
  corner?: number;
  angle?: number;
  tip?: number;
  flute_length?: number;
  length?: number;
  points?: string; // of an insert: direction of its programmed point
  lead?: number;
  width?: number;
  profile?: [number, number][];
  shank?: unknown;
  holder?: unknown;
  name?: string;
  flute_count?: number;
  from?: string;
  known?: boolean;
  by_offset?: boolean; // an insert of the offset table, which the cut takes from there
}
/// The outline of one body of a turning tool, [x, z] from the programmed point.
export interface Insert {
  tool: number;
  part: "cutting" | "shank" | "holder";
  outline: [number, number][];
}
export interface CutQuestion {
  stock: string;
  tools: string | Tool[];
  fixtures?: string[];
  resolution?: number;
}
/// A problem that the cut has found.
export interface Finding extends Problem {
  file: number;
  at: number;
  place: number[];
  depth: number;
  tool: number;
}
/// A thread as it was cut; lengths in mm.
export interface CutThread {
  line: number;
  tool: number;
  lead?: number;
  passes: number;
  outer: boolean;
  from: { diameter: number; Z: number };
  to: { diameter: number; Z: number };
  crest?: number;
  depth?: number;
}
export interface CutResult {
  stock: number;
  left: number;
  removed: number;
  error_bound?: number;
  resolution?: number;
  seconds?: number;
  alarms?: number;
  warnings?: number;
  tools?: { tool: number; removed: number; seconds: number; greatest_rate: number }[];
  marks?: Mark[];
  notes?: string[];
  inserts?: Insert[];
  turned?: { surface: number; machined: number };
  threads?: CutThread[];
  error?: { text: string };
}
export interface Proposals {
  stock: string;
  tools: Tool[];
  files?: string[];
  inserts?: Insert[];
}
/// Polygons of [radius, Z].
export type SectionPolygons = readonly (readonly (readonly [number, number])[])[];
export interface PartAnswer {
  stock: number;
  left: number;
  triangles: number;
  seconds: number;
  cell: number;
  section?: SectionPolygons;
  section_y?: SectionPolygons;
  edges?: readonly (readonly [number, number])[]; // radius and Z
}
export interface SheetTool {
  number: number;
  name?: string;
  radius?: number;
  length?: number;
  corrector?: string | number;
  seconds?: number;
  lines?: number[];
  outline?: [number, number][];
  comment?: string;
  shared?: { word: string; tools: number[] }[]; // of its offsets: other tools that use them too
}
export interface Sheet {
  program: string;
  control: string;
  machine: string | null;
  date: string;
  zeros: { name: string; values: Axes }[];
  diameters?: string[];
  tools: SheetTool[];
  extents: { cutting: Box | null; all: Box | null };
  seconds: number;
  comments: { line: number; text: string }[];
  stops: { line: number; text: string; at: number }[];
}
export interface Spot {
  line: number;
  file: number;
  number: number;
  at: number;
  to_line: number;
  to_number: number;
  to_at: number;
}
export interface Difference {
  kind: "way" | "move" | "feed" | "tool" | "spindle" | "coolant" | "act" | "end";
  text: string;
  distance: number;
  a: Spot;
  b: Spot;
}
export interface Compared {
  same: boolean;
  text: string;
  tolerance: number;
  deviation: number;
  moves: [number, number];
  first: Difference | null;
  differences: Difference[];
  more: number;
  lost: boolean;
}

/// Each question, with its contents and its answer.
export type PanelMode = "standing" | "running" | "held" | "ended" | "alarm" | "emergency";
export type PanelKey = "run" | "hold" | "reset" | "emergency" | "take" | "off" | "block" | "over" | "out";
export interface StopPoint {
  number: number;
  line: number;
  pass: number;
  call: string;
  condition: string;
  tool: number;
}
/// A machine at its panel: positions are a sample of the servo clock.
export interface Panel {
  mode: PanelMode;
  instant: number;
  position: Axes;
  machine: Axes;
  togo: Axes;
  feed: number;
  speed: number;
  share: number;
  override: number;
  rapid: number;
  spindle: number;
  dry_feed: number;
  asks: boolean;
  takes_tables: boolean;
  not_kept: string;
  line: number;
  file: number;
  text: string;
  number: number;
  entered: boolean;
  single: boolean;
  optional_stop: boolean;
  skip: number[];
  stops: StopPoint[];
  hit: number;
  told: string;
  why: "" | "M0" | "M1" | "restart";
  goes_there: boolean;
  can_undo: number;
  blocks: number;
  modal: Modal[];
  rpm: number | null;
  tool: number | null;
  offsets: { T?: number | null; D?: number | null; H?: number | null };
  zero: Axes;
  diameters?: string[];
  feed_per_turn?: number | null;
  surface?: Surface | null;
  tool_offset?: ToolOffset | null;
  calls: Call[];
  alarm: Problem | null;
  holds: boolean;
  held: boolean;
  limit: string;
  channels: PanelChannel[];
  digest: string; // of the program text that the machine runs
}
/// One of several channels; `waits`: its axes have reached a waiting code, which of the required channels (`channels`)
/// have too (`here`).
export interface PanelChannel {
  number: number;
  axes: string[];
  position: Axes;
  machine: Axes;
  diameters?: string[];
  feed: number;
  speed: number;
  moves: boolean;
  line: number;
  text: string;
  waits: { code: number; channels: number[]; here: number[] } | null;
}

/// Where a program restarts; `number` of the block in the run, `hole` of a canned cycle.
export interface RestartPlace {
  line?: number;
  pass?: number;
  of_file?: string;
  call?: string;
  condition?: string;
  number?: number;
  hole?: number;
}
export type ForceKind =
  | "position"
  | "machine"
  | "code"
  | "feed"
  | "speed"
  | "spindle"
  | "coolant"
  | "tool"
  | "selected"
  | "offset"
  | "length_offset"
  | "origin"
  | "length"
  | "rotation"
  | "scale"
  | "variable";
export interface RestartRow {
  key: string;
  kind: ForceKind;
  name: string;
  wanted: string | number | null;
  now: string | number | null;
  by: "" | "way" | "line" | "memory";
  may_be_left: boolean;
}
/// Machine coordinates of the axes that move, at the end of the step.
export interface WayPoint {
  rapid: boolean;
  to: Axes;
  feed: number;
}
export interface SearchCode {
  text: string;
  line: number;
}
/// `zero`: machine coordinates minus work coordinates at that position; `search`: the control's own.
export interface RestartSheet {
  ready: true;
  line: number;
  file: string;
  text: string;
  calls: Call[];
  rows: RestartRow[];
  way: WayPoint[];
  normal: string;
  zero: Axes;
  blocks: string[];
  by_hand: string;
  search: { carried_out: SearchCode[]; of_no_group: SearchCode[]; forgotten: string } | null;
  number: number;
  beside: BesideSheet[];
}
/// For another channel: its position at the restart, keys prefixed with its number; `number` of the sheet is the own
/// channel's.
export interface BesideSheet {
  number: number;
  line: number;
  text: string;
  stands: "before" | "within" | "waits" | "over";
  rows: RestartRow[];
  way: WayPoint[];
  zero: Axes;
  blocks: string[];
  by_hand: string;
}
/// The approach of one channel; the approaches are executed one after the other.
export interface ChannelWay {
  channel: number;
  way: WayPoint[];
}

/// Values of the set-up file, edits, and values from the control; variables with the line that set them (0: not set by
/// the program).
export interface Tables {
  sections: string[];
  setup: string;
  file: JsonTable;
  edited: JsonTable;
  now: JsonTable;
  variables: { name: string; value: number | null; line: number }[];
  lasts: boolean;
}
export interface LogEntry {
  at: string;
  kind: string;
  text: string;
  line: number;
}
export interface Stood {
  mode: PanelMode;
  number: number;
  line: number;
  file: string;
  text: string;
  machine: number[];
}

export type MillTask = "pocket" | "face" | "slot";
/// The question to `kadr mill`, by the names of its options; omitted options have their usual values.
export interface MillQuestion {
  drawing: string;
  control: string;
  task: MillTask;
  tool_diameter: number;
  depth: number;
  pass?: number;
  allowance?: number;
  top?: number;
  scheme?: string;
  direction?: string;
  stepover?: string;
  plunge?: string;
  hole?: [number, number];
  ramp_angle?: number;
  clearance?: number;
  overrun?: number;
  angle?: number;
  width?: number;
  feed?: number;
  plunge_feed?: number;
  speed?: number;
  tool?: number;
  coolant?: boolean;
  mark?: string;
}
/// `picture` SVG, "": too large to be shown; `warning` "": none; `name`: a file name that is not in use.
export interface Milled {
  text: string;
  picture: string;
  summary: { name: string; value: string }[];
  warning: string;
  name: string;
}
/// `word` of the question that is wrong, "": the drawing is.
export interface NotMilled {
  problem: Problem;
  word: string;
  line_text: string;
}
/// `bytes` in base64: one byte per row.
export interface Punched {
  bytes: string;
  rows: number;
  name: string;
}
export type TapeCode = "iso" | "eia";
export interface TapeRead {
  text: string;
  code: TapeCode;
  lies: string;
  faults: string[];
  more: number;
  name: string;
}

/// A program with the contents of `open`; `to` is the control to convert it for.
export type ConvertQuestion = OpenQuestion & { to: string; flat?: boolean; force?: boolean };
/// A rejected way of writing the program. `line` 0: at no line of the program; `file` 0: the program itself;
/// `written_line`: line of the text written for the other control, 0: none.
export interface ConversionTry {
  as: string;
  way: string;
  text: string;
  line: number;
  file: number;
  file_name: string;
  line_text: string;
  written_line: number;
  written_text: string;
}
export interface Converted {
  text: string;
  tolerance: number;
  written: {
    proven: boolean;
    as: string;
    way: string;
    program: string;
    setup: string;
    name: string;
    note: string;
    written_out: { from: number; to: number; text: string }[];
  } | null;
  tries: ConversionTry[];
}

export interface Questions {
  hello: [{ token?: string; lang: Language }, Hello];
  language: [{ lang: Language }, object];
  files: [{ folder: string }, Files];
  open: [OpenQuestion, Opened];
  source: [{ from: number; count: number; file?: number }, { lines: string[] }];
  state: [{ at: number } | { number: number }, State];
  passes: [{ line: number; file?: number }, Passes];
  check: [{ text: string }, Checked];
  explain: [{ line: number; text?: string }, Explained];
  cut: [CutQuestion, object];
  part: [{ at: number }, PartAnswer];
  proposals: [{ tools?: string }, Proposals];
  sheet: [object, Sheet];
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
  stop: [object, object];
  machines: [object, { machines: { name: string; mode: PanelMode | "kept"; held: boolean }[] }];
  machine: [
    OpenQuestion,
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
  jog: [{ axis: string; way: number; feed?: number; channel?: number }, object];
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
