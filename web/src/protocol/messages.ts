// The only reader of the messages between page and session (docs/panel-protocol.md): a text is a question, an answer
// or an event, bytes are a frame.
import { read_frame, type Frame } from "./frames";
import type { Events, Questions } from "./types";

export type SessionEvent = { [K in keyof Events]: { name: K; body: Events[K] } }[keyof Events];
/// `to`: number of the question. `changed`: another client has changed a file since it was opened.
export type Message =
  | { kind: "answer"; to: number; body: object }
  | { kind: "refusal"; to: number; text: string; changed: boolean }
  | { kind: "event"; event: SessionEvent }
  | { kind: "frame"; frame: Frame };
export interface Question {
  id: number;
  do: string;
  [field: string]: unknown;
}

/// Reads a message of the session; null for anything else.
export function read_message(data: unknown): Message | null {
  if (data instanceof ArrayBuffer) {
    const frame = read_frame(data);
    return frame && { kind: "frame", frame };
  }
  const said = typeof data === "string" ? object_of(data) : null;
  if (!said) return null;
  if ("re" in said) return read_answer(said);
  return typeof said.event === "string"
    ? { kind: "event", event: { name: said.event, body: said } as unknown as SessionEvent }
    : null;
}

function read_answer(said: Record<string, unknown>): Message {
  const to = said.re as number,
    error = said.error as { text: string; changed?: boolean } | undefined;
  return error
    ? { kind: "refusal", to, text: error.text, changed: error.changed === true }
    : { kind: "answer", to, body: said };
}

export const write_question = <K extends keyof Questions>(id: number, what: K, body: Questions[K][0]): string =>
  JSON.stringify({ id, do: what, ...body });

/// The other side, for a session inside the page itself.
export const read_question = (text: string): Question => JSON.parse(text) as Question;
export const write_answer = (to: number, body: object): string => JSON.stringify({ re: to, ...body });
export const write_event = <K extends keyof Events>(name: K, body: Events[K]): string =>
  JSON.stringify({ event: name, ...body });

function object_of(text: string): Record<string, unknown> | null {
  try {
    const found: unknown = JSON.parse(text);
    return typeof found === "object" && found !== null ? (found as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}
