// A socket of a session in the engine: to the page it looks like a WebSocket.
import type { Socket } from "../protocol/client";

/// What a question asks, without its number.
export const body_of = (text: string): string => text.replace(/"id":\s*\d+,?/, "");
export const id_of = (text: string): number => Number(/"id":\s*(\d+)/.exec(text)?.[1] ?? 0);
const is_stop = (text: string): boolean => text.length < 200 && /"do":\s*"stop"/.test(text);

/// What a socket asks of the engine.
export interface SocketOwner {
  take(socket: EngineSocket, text: string): void;
  stop(socket: EngineSocket): void;
  leave(socket: EngineSocket): void;
}

export class EngineSocket implements Socket {
  binaryType = "arraybuffer";
  readyState = 0;
  flag = URL.createObjectURL(new Blob(["1"])); // withdrawn: what was asked so far is to stop
  sent: string[] = []; // questions whose answer is not complete
  onopen: ((e: unknown) => void) | null = null;
  onclose: ((e: unknown) => void) | null = null;
  onmessage: ((e: { data: unknown }) => void) | null = null;

  constructor(
    private owner: SocketOwner,
    readonly session: number,
  ) {}

  send(text: string): void {
    if (this.readyState !== 1) return;
    if (is_stop(text)) this.owner.stop(this);
    this.sent.push(text);
    this.owner.take(this, text);
  }
  /// Ends the session with its worker.
  close(): void {
    if (this.readyState > 1) return;
    this.readyState = 3;
    this.owner.leave(this);
    URL.revokeObjectURL(this.flag);
    this.onclose?.(null);
  }
  opened(): void {
    if (this.readyState !== 0) return;
    this.readyState = 1;
    this.onopen?.(null);
  }
  /// Withdraws the flag of what was asked so far.
  stop(): void {
    URL.revokeObjectURL(this.flag);
    this.flag = URL.createObjectURL(new Blob(["1"]));
  }
}
