// The text of another program, by a second, short session: the first keeps what it has open.
import { Client, type Socket } from "../protocol/client";
import type { Language } from "../protocol/types";

export function other_text(make: () => Socket, hello: { token?: string; lang: Language }, file: string): Promise<string | null> {
  return new Promise((yes, no) => {
    const client: Client = new Client(make, async (c) => { await c.ask("hello", hello); });
    client.line.on(async (line) => {
      if (line === "connecting") return;
      try {
        if (line !== "open") throw new Error("no second session");
        yes((await client.ask("open", { file })).text ?? null);
      } catch (e) { no(e); }
      client.close(); // ends its run too
    });
    client.connect();
  });
}
