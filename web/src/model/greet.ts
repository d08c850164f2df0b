// The first word on every line to the server: who asks, and in which language answers are wanted.
import type { Client } from "../protocol/client";
import { token } from "../protocol/token";
import type { Hello } from "../protocol/types";
import { language } from "../texts/texts";

export function greet(client: Client): Promise<Hello> {
  const t = token();
  return client.ask("hello", t ? { token: t, lang: language() } : { lang: language() });
}
