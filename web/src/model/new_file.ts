// New files in the served folder: never over one that is there, unless this page wrote it and the user says so.
import { Refused } from "../protocol/client";
import { t } from "../texts/texts";
import type { App } from "./app";

const written = new Map<string, string>(); // digests of what was saved from dialogues, by name

export type Content = { text: string } | { bytes: string };

/// `may_replace` is asked where the file is there and was written here or is open.
///   returns  why it is not saved; "": it is
export async function save_new(
  app: App,
  file: string,
  content: Content,
  may_replace: () => Promise<boolean>,
): Promise<string> {
  const save = async (digest: string | null): Promise<void> => {
    written.set(file, (await app.client.ask("save", { file, ...content, digest })).digest);
  };
  const taken = (e: unknown): boolean => e instanceof Refused && e.changed;
  const told = (e: unknown): string =>
    taken(e) ? t("name_taken", { file }) : e instanceof Error ? e.message : String(e);
  try {
    await save(null);
    return "";
  } catch (e) {
    const digest = app.opened?.file === file && !app.dirty ? app.digest : written.get(file);
    if (!taken(e) || !digest || !(await may_replace())) return told(e);
    try {
      await save(digest);
      return "";
    } catch (again) {
      return told(again);
    }
  }
}

/// Files beneath the served folder that `wanted` likes, those of `first` in front: as many folders as can be asked for
/// while somebody waits.
export async function files_beneath(app: App, first: string, wanted: (name: string) => boolean): Promise<string[]> {
  const most_folders = 100,
    found: string[] = [],
    folders = [first, ...(first ? [""] : [])],
    seen = new Set<string>();
  while (folders.length && seen.size < most_folders) {
    const folder = folders.shift()!;
    if (seen.has(folder)) continue;
    seen.add(folder);
    const { entries } = await app.client.ask("files", { folder });
    for (const e of entries) {
      const path = folder ? `${folder}/${e.name}` : e.name;
      if (e.kind === "folder") folders.push(path);
      else if (wanted(e.name)) found.push(path);
    }
  }
  return found;
}
