// A session without a server: the questions of the page are answered from the report inside the page itself.
import type { Socket } from "../protocol/client";
import { read_frame, type PartFrame } from "../protocol/frames";
import { read_question, write_answer, write_event, type Question } from "../protocol/messages";
import type { Axes, Language, PartAnswer, Questions, State } from "../protocol/types";
import type { Report, Told } from "./data";
import { ReportPath } from "./path";

const most_passes = 1000,
  most_lines = 5000;
interface Refusal {
  error: { text: string };
}
type Answers = { [K in keyof Questions]?: (q: Question) => Questions[K][1] | Refusal };

export class ReportSocket implements Socket {
  binaryType = "arraybuffer";
  readyState = 0;
  onopen: Socket["onopen"] = null;
  onclose: Socket["onclose"] = null;
  onmessage: Socket["onmessage"] = null;
  private language: Language;
  private path!: ReportPath;
  private lines = new Map<number, string[]>();
  private part_frame: PartFrame | null = null;
  private part_is_shown = false;
  private answers: Answers = {
    hello: (q) =>
      this.speak(q, {
        version: this.report.data.version,
        folder: "",
        may_change: false,
        last: this.report.data.file,
        controls: [],
        machines: [],
      }),
    language: (q) => this.speak(q, {}),
    open: () => {
      this.part_is_shown = false;
      setTimeout(() => this.run());
      return this.told.opened;
    }, // after the answer has been processed
    source: (q) => ({
      lines: this.source(Number(q.file ?? 0)).slice(
        Number(q.from) - 1,
        Number(q.from) - 1 + Math.min(most_lines, Number(q.count)),
      ),
    }),
    state: (q) => this.state(q),
    passes: (q) => this.path.passes(Number(q.line), Number(q.file ?? 0), most_passes),
    sheet: () => this.told.sheet,
    part: () => this.part(),
    stop: () => ({}),
  };

  constructor(private report: Report) {
    this.language = report.data.language;
    this.replace(report);
    queueMicrotask(() => {
      this.readyState = 1;
      this.onopen?.({});
    });
  }

  /// The next `open` opens this report.
  replace(report: Report): void {
    this.report = report;
    this.path = new ReportPath(report.path);
    this.lines.clear();
    const part = report.part && read_frame(report.part);
    this.part_frame = part?.kind === "part" ? part : null;
  }

  send(text: string): void {
    const q = read_question(text);
    const answer = this.answers[q.do as keyof Questions];
    const body = answer ? answer(q) : { error: { text: "a report answers nothing of the kind" } };
    queueMicrotask(() => this.say(write_answer(q.id, body)));
  }
  close(): void {
    this.readyState = 3;
  }

  private get told(): Told {
    return this.report.data[this.language];
  }
  private say(text: string): void {
    this.onmessage?.({ data: text });
  }

  private speak<T>(q: Question, answer: T): T {
    this.language = q.lang === "ru" ? "ru" : "en";
    return answer;
  }

  /// Sends what a session sends after `open`. Frames are copied: the receiver may keep or transfer them.
  private run(): void {
    const { told } = this;
    for (const frame of this.report.path) this.onmessage?.({ data: frame.slice(0) });
    for (const problem of told.problems) this.say(write_event("alarm", { at: problem.at ?? 0, problem }));
    this.say(write_event("done", told.done));
    for (const finding of told.findings) this.say(write_event("finding", finding));
    if (told.cut) this.say(write_event("cut", told.cut));
  }

  /// Sends the final part once, for every instant.
  private part(): PartAnswer | Refusal {
    const { part, data } = this.report,
      cut = this.told.cut;
    if (!part || !this.part_frame || !cut) return { error: { text: "no part" } };
    if (!this.part_is_shown) this.onmessage?.({ data: part.slice(0) });
    this.part_is_shown = true;
    return {
      stock: cut.stock,
      left: cut.left,
      triangles: this.part_frame.triangles.length / 3,
      seconds: 0,
      cell: data.part?.cell ?? cut.resolution ?? 0,
      ...(data.part?.section
        ? { section: data.part.section, section_y: data.part.section_y, edges: data.part.edges }
        : {}),
    };
  }

  private source(file: number): string[] {
    let lines = this.lines.get(file);
    if (!lines)
      this.lines.set(file, (lines = (this.report.data.sources.find((s) => s.file === file)?.text ?? "").split("\n")));
    return lines;
  }

  /// Answers from the path: only a session has codes in force, variables and calls.
  private state(q: Question): State | Refusal {
    const { done, opened } = this.told;
    const s = q.number === undefined ? this.path.at(Number(q.at)) : this.path.of_block(Number(q.number));
    if (!s) return { error: { text: "no path" } };
    const axes = ["X", "Y", "Z"].filter((a) => !done.axes.length || done.axes.includes(a)); // a lathe has no Y
    const of_axes = (v: number[], zero: number[]): Axes =>
      Object.fromEntries(axes.map((name) => [name, v["XYZ".indexOf(name)]! - zero["XYZ".indexOf(name)]!]));
    const file_name = s.file === 0 ? "" : (this.report.data.sources.find((x) => x.file === s.file)?.name ?? "");
    return {
      at: s.at,
      number: s.number,
      line: s.line,
      column: 1,
      file: s.file,
      file_name: file_name || opened.file,
      block: "",
      text: this.source(s.file)[s.line - 1] ?? "",
      position: of_axes(s.place, done.zero),
      machine: {},
      togo: of_axes(s.left, [0, 0, 0]),
      feed: s.feed,
      speed: s.speed,
      rpm: null,
      tool: s.tool,
      modal: [],
      offsets: {},
      zero: {},
      diameters: done.diameters ?? [],
      variables: [],
      calls: [],
      seconds: s.at,
      left: Math.max(0, done.seconds - s.at),
    };
  }
}
