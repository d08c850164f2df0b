// The commands of the palette.
import { dirname } from "node:path";
import * as vscode from "vscode";
import { run_kadr } from "./kadr";
import { controls_in } from "./languages";
import { PathView } from "./path_view";
import { report_words } from "./report";
import { choice_words } from "./settings";
import { task_of } from "./tasks";
import { active_program, settings, tell } from "./workspace";

export async function show_path(): Promise<void> {
  const document = active_program();
  if (document) await PathView.show(document);
}

export async function start_task(command: "check" | "run"): Promise<void> {
  const document = active_program();
  if (!document || !(await document.save())) return;
  const folder = vscode.workspace.getWorkspaceFolder(document.uri);
  await vscode.tasks.executeTask(task_of({ type: "kadr", command, file: document.uri.fsPath }, folder));
}

export async function write_report(): Promise<void> {
  const document = active_program();
  if (!document || !(await document.save())) return;
  const path = document.uri.fsPath,
    s = settings(document.uri);
  const out = await vscode.window.showSaveDialog({
    defaultUri: vscode.Uri.file(path.replace(/(\.[^./\\]*)?$/, ".html")),
    filters: { HTML: ["html"] },
  });
  if (!out) return;
  const ran = await run_kadr(s.path, report_words(path, dirname(path), out.fsPath, s), dirname(path));
  if (ran.status !== 0 && ran.status !== 1) return tell(ran.told);
  const open = vscode.l10n.t("Open");
  const chosen = await vscode.window.showInformationMessage(vscode.l10n.t("Written: {0}", out.fsPath), open);
  if (chosen === open) await vscode.env.openExternal(out);
}

/// Asks for a control.  returns its id
async function ask_control(path: string, title: string, none = false): Promise<string | undefined> {
  const s = settings(),
    listed = controls_in((await run_kadr(path, ["controls", "--lang", s.language], process.cwd())).out);
  const rows = listed.map(({ id, name }) => ({ label: id, description: name }));
  if (none) rows.unshift({ label: "", description: vscode.l10n.t("by .kadr.toml or by a guess") });
  return (await vscode.window.showQuickPick(rows, { title, matchOnDescription: true }))?.label;
}

/// Opens the program for another control next to this one. A conversion that is not proven is not written.
export async function convert(): Promise<void> {
  const document = active_program();
  if (!document || !(await document.save())) return;
  const path = document.uri.fsPath,
    s = settings(document.uri);
  const to = await ask_control(s.path, vscode.l10n.t("Convert for which control?"));
  if (!to) return;
  const words = ["convert", path, "--to", to, "--lang", s.language, "--encoding-out", "utf-8", ...choice_words(s)];
  const ran = await run_kadr(s.path, words, dirname(path));
  if (ran.status !== 0) return tell(ran.told);
  const made = await vscode.workspace.openTextDocument({ language: `nc-${to}`, content: ran.out });
  await vscode.window.showTextDocument(made, vscode.ViewColumn.Beside);
}

export async function choose_control(): Promise<void> {
  const of = vscode.window.activeTextEditor?.document.uri,
    read = vscode.workspace.getConfiguration("kadr", of);
  const chosen = await ask_control(settings(of).path, vscode.l10n.t("Control of the programs here"), true);
  if (chosen === undefined) return;
  const target = vscode.workspace.workspaceFolders
    ? vscode.ConfigurationTarget.Workspace
    : vscode.ConfigurationTarget.Global;
  await read.update("control", chosen || undefined, target);
}
