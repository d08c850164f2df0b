// The first message on every connection to the server: who asks, and the language of the answers.
import type { Client } from "../protocol/client";
import { token } from "../protocol/token";
import type { Hello } from "../protocol/types";
import { language } from "../texts/texts";

export function greet(client: Client): Promise<Hello> {
  const t = token();
  return client.ask("hello", t ? { token: t, lang: language() } : { lang: language() });
}
