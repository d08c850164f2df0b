// Texts in the language of the page: `t(key)` now, `on_language` to be told when it changes.
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

/// Everything that is written is written anew: its figures are in another unit.
export const write_anew = (): void => changed.emit(current);

/// The text of a key, `{name}` in it replaced. A key made of what the session says may be one that a newer session
/// knows: it stands for itself.
export function t(key: TextKey, with_?: Record<string, string | number>): string {
  return (tables[current][key] ?? key).replace(/\{(\w+)\}/g, (all, name: string) => String(with_?.[name] ?? all));
}
export type { TextKey };
