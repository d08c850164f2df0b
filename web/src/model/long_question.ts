// A question that may take long, on a connection of its own to the server: it delays nothing else, and is stopped when
// something else is requested.
import { Client, Lost, Refused, type Socket } from "../protocol/client";
import type { Questions } from "../protocol/types";
import { greet } from "./greet";
import { Latest } from "./latest";
import { Signal } from "./signal";

export class LongQuestion<K extends "mill" | "convert" | "edit_program"> {
  answer: Questions[K][1] | null = null; // the last answer; it belongs to the current question only if `busy` is false
  refusal = "";
  busy = false;
  readonly on_change = new Signal<void>();
  private wanted: Questions[K][0] | null = null;
  private client: Client;
  private wishes = new Latest<Questions[K][0]>((q) => this.fetch(q));
  private under_way = false;

  constructor(
    make: () => Socket,
    private what: K,
  ) {
    this.client = new Client(make, greet);
    this.client.line.on((l) => {
      if (l === "open" && this.wanted && this.busy) this.wishes.want(this.wanted);
    });
    this.client.connect();
  }

  /// null: nothing is requested any more. `again`: the answer to the same question may have changed.
  want(question: Questions[K][0] | null, again = false): void {
    if (!again && question && JSON.stringify(question) === JSON.stringify(this.wanted)) return;
    this.wanted = question;
    this.busy = question !== null;
    this.refusal = "";
    if (!question) this.answer = null;
    if (this.under_way) this.client.ask("stop", {}).catch(() => undefined);
    this.on_change.emit();
    if (question) this.wishes.want(question);
  }

  close(): void {
    this.client.close();
  }

  private async fetch(question: Questions[K][0]): Promise<void> {
    if (question !== this.wanted) return;
    this.under_way = true;
    try {
      const answer = await this.client.ask(this.what, question);
      if (question === this.wanted) this.take(answer, "");
    } catch (e) {
      if (question === this.wanted && !(e instanceof Lost))
        this.take(null, e instanceof Refused ? e.message : String(e)); // after a lost connection the question is sent again
    } finally {
      this.under_way = false;
    }
  }

  private take(answer: Questions[K][1] | null, refusal: string): void {
    this.answer = answer;
    this.refusal = refusal;
    this.busy = false;
    this.on_change.emit();
  }
}
