// Edited texts that were not saved, kept in this browser for the next visit: one per tab and file, in localStorage,
// which outlives the tab. A tab's own text returns by itself after a reload; others are offered.
import { forget, names_kept, remember, remembered } from "./memory";
import { Signal } from "./signal";

export interface KeptText {
  name: string; // in the store
  file: string;
  text: string;
  digest: string | null; // of the file that it was edited from
  at: number; // ms since 1970
}

const most_text = 2_000_000; // characters: a browser keeps some five million in all
const store_name = (folder: string, file: string): string => `unsaved:${folder}/${file}:`;

export class Unsaved {
  readonly on_offer = new Signal<KeptText[]>(); // from an earlier visit or another tab
  private folder = "";
  private here = ""; // the file whose text this page has kept
  private offered = new Set<string>();
  private readonly tab: string;

  constructor() {
    this.tab = remembered("tab", "", "tab") || Math.random().toString(36).slice(2);
    remember("tab", this.tab, "tab");
  }

  /// Kept programs of the served folder.
  of_folder(folder: string): void {
    this.folder = folder;
  }

  /// Keeps the current text; `text` null: nothing is unsaved, and what this page kept of the file is removed. If the
  /// browser has no room for the text, the only protection is the question before the tab closes.
  keep(file: string, text: string | null, digest: string | null): void {
    const name = store_name(this.folder, file) + this.tab;
    if (text === null) {
      if (this.here === file) forget(name);
      return;
    }
    this.here = file;
    if (text.length > most_text) return forget(name); // better no text than an old one
    const kept: KeptText = { name, file, text, digest, at: Date.now() };
    while (!remember(name, kept)) {
      const oldest = this.all("unsaved:").filter((k) => k.name !== name)[0];
      if (!oldest) return forget(name);
      forget(oldest.name);
    }
  }

  /// The text of this tab, after a reload.
  own(file: string): KeptText | null {
    this.here = file;
    return this.all(store_name(this.folder, file)).find((k) => k.name.endsWith(`:${this.tab}`)) ?? null;
  }

  /// A file was opened as it is on the disk: reports the texts to offer, the latest first, each once.
  offer(file: string, on_disk: string): void {
    const all = this.all(store_name(this.folder, file)).reverse();
    for (const kept of all) if (kept.text === on_disk) forget(kept.name);
    const fresh = all.filter((k) => k.text !== on_disk && !this.offered.has(k.name));
    for (const kept of fresh) this.offered.add(kept.name);
    if (fresh.length) this.on_offer.emit(fresh);
  }

  /// A program has been renamed: texts that are kept of it, also by other tabs, are offered under its new name.
  rename(from: string, to: string): void {
    for (const kept of this.all(store_name(this.folder, from))) {
      const name = store_name(this.folder, to) + kept.name.slice(kept.name.lastIndexOf(":") + 1);
      if (remember(name, { ...kept, name, file: to })) forget(kept.name);
    }
    if (this.here === from) this.here = to;
  }

  drop(kept: KeptText): void {
    forget(kept.name);
  }

  /// The oldest first.
  private all(begins: string): KeptText[] {
    return names_kept(begins)
      .map((name) => ({ ...(remembered<KeptText | null>(name, null) as KeptText), name }))
      .filter((k) => typeof k.text === "string" && typeof k.file === "string")
      .sort((a, b) => a.at - b.at);
  }
}
