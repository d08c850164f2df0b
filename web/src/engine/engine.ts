// The engine of a page without a server: one worker, in which each view of the page has a session, and the files of the
// page. A socket of a session looks to the page like one to a server.
import type { Socket } from "../protocol/client";
import type { FileBytes, FromWorker, ToWorker } from "./messages";
import type { Parts } from "./parts";

const patience = 700; // ms that a worker which hears nothing gets to finish by itself, before it is replaced

export interface EngineTexts {
  memory(): string;
  broken(): string;
  stopped(): string;
}
export interface Keeper {
  keep(changed: FileBytes[], gone: string[]): Promise<boolean>;
}

/// What a question asks, without its number.
const body_of = (text: string): string => text.replace(/"id":\s*\d+,?/, "");
const id_of = (text: string): number => Number(/"id":\s*(\d+)/.exec(text)?.[1] ?? 0);
const is_stop = (text: string): boolean => text.length < 200 && /"do":\s*"stop"/.test(text);

export class EngineSocket implements Socket {
  binaryType = "arraybuffer";
  readyState = 0;
  flag = URL.createObjectURL(new Blob(["1"])); // withdrawn: what was asked so far is to stop
  sent: string[] = []; // questions whose answer is not complete
  onopen: ((e: unknown) => void) | null = null;
  onclose: ((e: unknown) => void) | null = null;
  onmessage: ((e: { data: unknown }) => void) | null = null;

  constructor(
    private engine: Engine,
    readonly session: number,
  ) {}

  send(text: string): void {
    if (this.readyState !== 1) return;
    if (is_stop(text)) this.engine.stop(this);
    this.sent.push(text);
    this.engine.take(this, text);
  }
  close(): void {
    if (this.readyState > 1) return;
    this.engine.leave(this);
    this.lost();
  }
  opened(): void {
    this.readyState = 1;
    this.onopen?.(null);
  }
  lost(): void {
    if (this.readyState > 1) return;
    this.readyState = 3;
    URL.revokeObjectURL(this.flag);
    this.onclose?.(null);
  }
  /// Withdraws the flag of what was asked so far.
  stop(): void {
    URL.revokeObjectURL(this.flag);
    this.flag = URL.createObjectURL(new Blob(["1"]));
  }
}

export class Engine {
  private worker: Worker | null = null;
  private stops = false;
  private sockets = new Map<number, EngineSocket>();
  private waiting: EngineSocket[] = []; // until the worker is ready
  private puts = new Map<number, () => void>();
  private count = 0;
  private too_much = ""; // the question for which the memory was not sufficient: it is not asked again
  private stopped = ""; // the question that a stop has ended with its worker: the page asks it again, which is refused once
  private files = new Map<string, ArrayBuffer>();
  private address = "";

  constructor(
    private parts: () => Promise<Parts>,
    private folder: string,
    files: FileBytes[],
    private keeper: Keeper,
    private texts: EngineTexts,
    private failed: (text: string) => void,
    private make_worker: (address: string) => Worker = (address) => new Worker(address),
  ) {
    this.files = new Map(files);
    void this.begin();
  }

  socket(): EngineSocket {
    const socket = new EngineSocket(this, ++this.count);
    this.waiting.push(socket);
    if (this.worker) this.let_in();
    return socket;
  }

  /// The bytes of a file of the page, to be saved on the computer.
  bytes_of(path: string): ArrayBuffer | undefined {
    return this.files.get(path);
  }
  /// Puts files into the folder; folders on the way are made.
  put(files: FileBytes[]): Promise<void> {
    const id = ++this.count;
    for (const [path, bytes] of files) this.files.set(path, bytes);
    return new Promise((yes) => {
      this.puts.set(id, yes);
      if (this.worker) this.post({ do: "put", files, id });
      else yes();
    });
  }

  take(socket: EngineSocket, text: string): void {
    const body = body_of(text);
    if (body === this.too_much) return this.refuse(socket, text, this.texts.memory());
    if (body === this.stopped) {
      this.stopped = "";
      return this.refuse(socket, text, this.texts.stopped());
    }
    this.post({ do: "take", session: socket.session, text, flag: socket.flag, at: Date.now() });
  }
  leave(socket: EngineSocket): void {
    this.waiting = this.waiting.filter((s) => s !== socket);
    if (!this.sockets.delete(socket.session)) return;
    socket.stop();
    this.post({ do: "close", session: socket.session });
  }
  stop(socket: EngineSocket): void {
    const before = socket.sent[0];
    socket.stop();
    if (this.stops || before === undefined) return;
    setTimeout(() => {
      if (socket.sent[0] !== before) return;
      this.stopped = body_of(before);
      this.replace();
    }, patience);
  }

  private post(message: ToWorker): void {
    this.worker?.postMessage(message);
  }

  private async begin(): Promise<void> {
    try {
      const { script, module, viewer, licences } = await this.parts();
      this.address ||= URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
      const worker = this.make_worker(this.address);
      worker.onmessage = (e: MessageEvent<FromWorker>) => this.hear(worker, e.data);
      worker.onerror = (e) => this.failed(e.message || this.texts.broken());
      const flag = URL.createObjectURL(new Blob(["1"]));
      const files = [...this.files],
        begin: ToWorker = { do: "begin", module, folder: this.folder, files, flag, viewer, licences };
      worker.postMessage(begin);
    } catch (e) {
      this.failed(e instanceof Error ? e.message : String(e));
    }
  }

  /// A worker that cannot receive a stop, or is broken, is ended; another one gets the files.
  private replace(): void {
    this.worker?.terminate();
    this.worker = null;
    for (const done of this.puts.values()) done();
    this.puts.clear();
    const all = [...this.sockets.values()];
    this.sockets.clear();
    void this.begin();
    for (const socket of all) socket.lost(); // each asks for a new one
  }

  private hear(worker: Worker, message: FromWorker): void {
    if (message.is === "ready") {
      this.worker = worker;
      this.stops = message.stops;
      return this.let_in();
    }
    if (message.is === "failed") return this.failed(message.text);
    if (message.is === "files") return this.take_files(message.changed, message.gone);
    if (worker !== this.worker) return;
    if (message.is === "put") {
      this.puts.get(message.id)?.();
      this.puts.delete(message.id);
      return;
    }
    const socket = this.sockets.get(message.session);
    if (message.is === "out") return socket?.onmessage?.({ data: message.data });
    const question = socket?.sent.shift() ?? "";
    if (!message.end) return;
    if (message.end !== "closed") this.too_much = body_of(question);
    const text = message.end === "memory" ? this.texts.memory() : message.end === "broken" ? this.texts.broken() : "";
    if (text) socket?.onmessage?.({ data: JSON.stringify({ event: "closed", text }) });
    if (message.end !== "closed") return this.replace();
    this.sockets.delete(message.session);
    socket?.lost();
  }

  private take_files(changed: FileBytes[], gone: string[]): void {
    const other = changed.filter(([path, bytes]) => !same(this.files.get(path), bytes));
    for (const [path, bytes] of changed) this.files.set(path, bytes);
    for (const path of gone) this.files.delete(path);
    if (other.length || gone.length) void this.keeper.keep(other, gone);
  }

  private let_in(): void {
    const all = this.waiting;
    this.waiting = [];
    for (const socket of all) {
      this.sockets.set(socket.session, socket);
      this.post({ do: "open", session: socket.session });
      setTimeout(() => socket.readyState === 0 && socket.opened(), 0); // its owner sets its functions first
    }
  }

  private refuse(socket: EngineSocket, text: string, why: string): void {
    socket.sent.pop();
    const answer = JSON.stringify({ re: id_of(text), error: { text: why } });
    setTimeout(() => socket.onmessage?.({ data: answer }), 0);
  }
}

function same(a: ArrayBuffer | undefined, b: ArrayBuffer): boolean {
  if (!a || a.byteLength !== b.byteLength) return false;
  const x = new Uint8Array(a),
    y = new Uint8Array(b);
  return x.every((byte, i) => byte === y[i]);
}
