// Reports of the program `kadr report`: a page with the path of a program and its data inside.
import { mkdir, mkdtemp, readFile, rm, writeFile, copyFile } from "node:fs/promises";
import { existsSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join } from "node:path";
import { run_kadr } from "./kadr";
import { choice_words, type Settings } from "./settings";

export interface Program {
  path: string;
  text?: string; // as it is in the editor, if it is not saved
}

/// The words of the command line that writes a report of a program.
export function report_words(program: string, files: string, out: string, s: Settings): string[] {
  return ["report", program, "--files", files, "--out", out, "--quiet", "--lang", s.language, ...choice_words(s)];
}

/// Returns the page, or the messages of the program if it writes none; null if `stop` has ended the work.
export async function made_report(
  program: Program,
  s: Settings,
  stop: AbortSignal,
): Promise<{ html: string } | { told: string } | null> {
  const folder = await mkdtemp(join(tmpdir(), "kadr-view-")),
    files = dirname(program.path),
    out = join(folder, "view.html");
  try {
    const path = program.text === undefined ? program.path : await staged(program.path, program.text, folder);
    const ran = await run_kadr(s.path, report_words(path, files, out, s), files, stop);
    if (stop.aborted) return null;
    if (!existsSync(out)) return { told: ran.told.trim() || `kadr report: ${ran.status}` };
    return { html: await readFile(out, "utf8") };
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

/// Writes a text that is not saved into a folder of the same name, with the `.kadr.toml` that applies to it, so that the
/// control is chosen as for the file itself.
async function staged(path: string, text: string, under: string): Promise<string> {
  const folder = join(under, basename(dirname(path)) || "programs");
  await mkdir(folder);
  const chosen = above(dirname(path), ".kadr.toml");
  if (chosen) await copyFile(chosen, join(folder, ".kadr.toml"));
  await writeFile(join(folder, basename(path)), text);
  return join(folder, basename(path));
}

function above(folder: string, name: string): string | null {
  if (existsSync(join(folder, name))) return join(folder, name);
  return folder === dirname(folder) ? null : above(dirname(folder), name);
}

/// Returns the data inside a report; null if the page is no report.
export function data_of(html: string): string | null {
  return /<script id="kadr-data" type="text\/plain">([^<]*)<\/script>/.exec(html)?.[1] ?? null;
}
