// One WebSocket to the session: numbered questions with promises, events, binary frames; it reconnects by itself when
// the connection is lost.
import { Signal } from "../model/signal";
import type { Frame } from "./frames";
import { read_message, write_question, type SessionEvent } from "./messages";
import type { Questions } from "./types";

/// A refusal. `changed`: another client has changed a file since it was opened.
export class Refused extends Error {
  constructor(
    text: string,
    readonly changed = false,
  ) {
    super(text);
  }
}
/// The connection was lost before the answer came.
export class Lost extends Error {}

export interface Socket {
  binaryType: string;
  readonly readyState: number;
  send(text: string): void;
  close(): void;
  onopen: ((e: unknown) => void) | null;
  onclose: ((e: unknown) => void) | null;
  onmessage: ((e: { data: unknown }) => void) | null;
}
export type LineState = "connecting" | "open" | "lost" | "refused";

const first_wait = 250,
  longest_wait = 8000; // ms between tries: short after a brief interruption, long while the server is gone

export class Client {
  readonly line = new Signal<LineState>();
  readonly frame = new Signal<Frame>();
  readonly event = new Signal<SessionEvent>();
  private socket: Socket | null = null;
  private waiting = new Map<number, { yes: (a: never) => void; no: (e: Error) => void }>();
  private next = 1;
  private tries = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private over = false;

  /// `greet` runs on every new connection before any other question: it says hello.
  constructor(
    private make: () => Socket,
    private greet: (client: Client) => Promise<unknown>,
  ) {}

  connect(): void {
    clearTimeout(this.timer);
    this.line.emit("connecting");
    const socket = this.make();
    this.socket = socket;
    socket.binaryType = "arraybuffer";
    socket.onopen = () => this.opened(socket);
    socket.onclose = () => {
      if (socket === this.socket) this.lost();
    };
    socket.onmessage = (e) => {
      if (socket === this.socket) this.take(e.data);
    };
  }

  ask<K extends keyof Questions>(what: K, body: Questions[K][0]): Promise<Questions[K][1]> {
    const socket = this.socket;
    if (!socket || socket.readyState !== 1) return Promise.reject(new Lost("not connected"));
    const id = this.next++;
    return new Promise((yes, no) => {
      this.waiting.set(id, { yes: yes as (a: never) => void, no });
      socket.send(write_question(id, what, body));
    });
  }

  close(): void {
    this.over = true;
    clearTimeout(this.timer);
    this.socket?.close();
  }

  private opened(socket: Socket): void {
    this.greet(this).then(
      () => {
        this.tries = 0;
        this.line.emit("open");
      },
      (e) => {
        if (!(e instanceof Refused)) return socket.close();
        this.over = true; // another try with the same token would be refused too
        this.line.emit("refused");
      },
    );
  }

  private lost(): void {
    this.socket = null;
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    for (const w of waiting) w.no(new Lost("connection lost"));
    if (this.over) return;
    this.line.emit("lost");
    this.timer = setTimeout(() => this.connect(), wait_before(this.tries++));
  }

  private take(data: unknown): void {
    const message = read_message(data);
    if (!message) return;
    if (message.kind === "frame") return this.frame.emit(message.frame);
    if (message.kind === "event") return this.event.emit(message.event);
    const who = this.waiting.get(message.to);
    if (!who) return;
    this.waiting.delete(message.to);
    if (message.kind === "refusal") who.no(new Refused(message.text, message.changed));
    else who.yes(message.body as never);
  }
}

/// Returns the ms before try number `tries`, doubled each time up to a limit.
export function wait_before(tries: number): number {
  return Math.min(longest_wait, first_wait * 2 ** Math.min(tries, 10));
}
