// Texts in the language of the page: `t(key)` returns one now, `on_language` reports a change of language.
import { Signal } from "../model/signal";
import { remember, remembered } from "../model/memory";
import type { Language } from "../protocol/types";
import { en, type TextKey } from "./en";
import { ru } from "./ru";

const tables: Record<Language, Record<TextKey, string>> = { en, ru };
const changed = new Signal<Language>();
let current: Language = remembered<Language>(
  "language",
  (globalThis.navigator?.language ?? "en").startsWith("ru") ? "ru" : "en",
);

export const language = (): Language => current;
export function set_language(lang: Language): void {
  current = lang;
  remember("language", lang);
  document.documentElement.lang = lang;
  changed.emit(lang);
}
export const on_language = (f: () => void): (() => void) => changed.on(f);

/// Writes all texts again: the unit of the figures has changed.
export const write_anew = (): void => changed.emit(current);

/// Returns the text of a key, with `{name}` replaced. A key built from a session's message may come from a newer
/// session and be unknown: then the key itself is returned.
export function t(key: TextKey, with_?: Record<string, string | number>): string {
  return (tables[current][key] ?? key).replace(/\{(\w+)\}/g, (all, name: string) => String(with_?.[name] ?? all));
}
export type { TextKey };
