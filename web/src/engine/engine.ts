// The engine of a page without a server. Each view of the page has a session in a worker of its own, so that a long
// conversion does not delay the program that is shown; the engine holds the files of the page, of which every worker
// has a copy. A socket of a session looks to the page like one to a server.
import type { FileBytes, FromWorker, ToWorker } from "./messages";
import type { Parts } from "./parts";
import { body_of, EngineSocket, id_of } from "./socket";

const patience = 700; // ms that a worker which hears nothing gets to finish by itself, before it is replaced

export interface EngineTexts {
  memory(): string;
  broken(): string;
  stopped(): string;
}
export interface Keeper {
  keep(changed: FileBytes[], gone: string[]): Promise<boolean>;
}

interface Seat {
  worker: Worker | null; // null until it has been made
  ready: boolean;
}

export class Engine {
  private seats = new Map<EngineSocket, Seat>();
  private stops = false; // whether a worker can receive a stop while it works
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
  }

  socket(): EngineSocket {
    const socket = new EngineSocket(this, ++this.count);
    this.seats.set(socket, { worker: null, ready: false });
    void this.begin(socket);
    return socket;
  }

  /// The bytes of a file of the page, to be saved on the computer.
  bytes_of(path: string): ArrayBuffer | undefined {
    return this.files.get(path);
  }
  /// Puts files into the folder; folders on the way are made. Every question that is asked later finds them.
  put(files: FileBytes[]): void {
    for (const [path, bytes] of files) this.files.set(path, bytes);
    this.tell_all({ do: "put", files, gone: [] });
    void this.keeper.keep(files, []);
  }

  take(socket: EngineSocket, text: string): void {
    const body = body_of(text);
    if (body === this.too_much) return this.refuse(socket, text, this.texts.memory());
    if (body === this.stopped) {
      this.stopped = "";
      return this.refuse(socket, text, this.texts.stopped());
    }
    this.post(socket, { do: "take", text, flag: socket.flag, at: Date.now() });
  }
  leave(socket: EngineSocket): void {
    this.seats.get(socket)?.worker?.terminate();
    this.seats.delete(socket);
  }
  stop(socket: EngineSocket): void {
    const before = socket.sent[0];
    socket.stop();
    if (this.stops || before === undefined) return;
    setTimeout(() => {
      if (socket.sent[0] !== before) return;
      if (/"do":\s*"open"/.test(before)) this.stopped = body_of(before);
      socket.close(); // the page asks for another one
    }, patience);
  }

  private post(socket: EngineSocket, message: ToWorker): void {
    this.seats.get(socket)?.worker?.postMessage(message);
  }
  private tell_all(message: ToWorker, but?: EngineSocket): void {
    for (const [socket, seat] of this.seats) if (socket !== but) seat.worker?.postMessage(message);
  }

  private async begin(socket: EngineSocket): Promise<void> {
    try {
      const { script, module, viewer, licences } = await this.parts();
      const seat = this.seats.get(socket);
      if (!seat) return; // it was closed meanwhile
      this.address ||= URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
      const worker = this.make_worker(this.address);
      seat.worker = worker;
      worker.onmessage = (e: MessageEvent<FromWorker>) => this.hear(socket, e.data);
      worker.onerror = (e) => this.failed(e.message || this.texts.broken());
      const files = [...this.files],
        begin: ToWorker = { do: "begin", module, folder: this.folder, files, flag: socket.flag, viewer, licences };
      worker.postMessage(begin);
    } catch (e) {
      this.failed(e instanceof Error ? e.message : String(e));
    }
  }

  private hear(socket: EngineSocket, message: FromWorker): void {
    const seat = this.seats.get(socket);
    if (message.is === "failed") return this.failed(message.text);
    if (!seat) return;
    if (message.is === "ready") {
      this.stops = message.stops;
      seat.ready = true;
      return void setTimeout(() => socket.opened(), 0); // its owner sets its functions first
    }
    if (message.is === "files") return this.take_files(socket, message.changed, message.gone);
    if (message.is === "out") return socket.onmessage?.({ data: message.data });
    const question = socket.sent.shift() ?? "";
    if (!message.end) return;
    if (message.end !== "closed") {
      this.too_much = body_of(question);
      const text = message.end === "memory" ? this.texts.memory() : this.texts.broken();
      socket.onmessage?.({ data: JSON.stringify({ event: "closed", text }) });
    }
    socket.close();
  }

  private take_files(from: EngineSocket, changed: FileBytes[], gone: string[]): void {
    const other = changed.filter(([path, bytes]) => !same(this.files.get(path), bytes));
    const left = gone.filter((path) => this.files.has(path));
    for (const [path, bytes] of changed) this.files.set(path, bytes);
    for (const path of gone) this.files.delete(path);
    if (!other.length && !left.length) return;
    this.tell_all({ do: "put", files: other, gone: left }, from);
    void this.keeper.keep(other, left);
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
