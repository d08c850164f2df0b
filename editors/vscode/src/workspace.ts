// Settings and programs of VS Code's workspace.
import * as vscode from "vscode";
import { is_program } from "./languages";
import { settings_of, type Settings } from "./settings";
import type { Program } from "./report";

export function settings(of?: vscode.Uri): Settings {
  const read = vscode.workspace.getConfiguration("kadr", of);
  const folder = (of && vscode.workspace.getWorkspaceFolder(of)) ?? vscode.workspace.workspaceFolders?.[0];
  return settings_of((name) => read.get<string>(name), folder?.uri.fsPath, vscode.env.language);
}

/// Returns the document of the active editor if it is a program on the disk; otherwise says so.
export function active_program(): vscode.TextDocument | null {
  const document = vscode.window.activeTextEditor?.document;
  if (document && is_program(document.languageId) && document.uri.scheme === "file") return document;
  void vscode.window.showInformationMessage(vscode.l10n.t("Open a program first."));
  return null;
}

export function program_of(document: vscode.TextDocument): Program {
  return { path: document.uri.fsPath, ...(document.isDirty ? { text: document.getText() } : {}) };
}

/// Shows why something failed; if the program is not found, with a way to the setting.
export async function tell(e: unknown): Promise<void> {
  const text = e instanceof Error ? e.message : String(e),
    open = vscode.l10n.t("Settings");
  if ((await vscode.window.showErrorMessage(text, open)) === open)
    await vscode.commands.executeCommand("workbench.action.openSettings", "kadr.path");
}
