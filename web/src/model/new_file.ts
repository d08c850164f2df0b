// New files in the served folder: an existing file is never replaced, unless this page wrote it and the user agrees.
import { Refused } from "../protocol/client";
import { t } from "../texts/texts";
import type { App } from "./app";

const written = new Map<string, string>(); // digests of files saved from dialogues, by name

export type Content = { text: string } | { bytes: string };

/// Saves a file; `may_replace` asks the user if the file exists and was written here or is open.
///   returns  why it is not saved; "" if it is saved
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

/// Returns the files below the served folder that `wanted` accepts, those of `first` in front: from as many folders as
/// can be read while somebody waits.
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
