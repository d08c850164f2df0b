// Kadr in VS Code: language server, debugger, tasks, and the view of the path.
import * as vscode from "vscode";
import { Server } from "./client";
import { choose_control, convert, show_path, start_task, write_report } from "./commands";
import { debugging } from "./debugging";
import { control_of_folder, is_program, language_of } from "./languages";
import { tasks } from "./tasks";
import { settings, tell } from "./workspace";

const server = new Server();

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const known = await vscode.languages.getLanguages();
  const restart = async (): Promise<void> => {
    await server.stop();
    await server.start(known);
  };
  const commands: Record<string, () => Promise<void>> = {
    showPath: show_path,
    check: () => start_task("check"),
    run: () => start_task("run"),
    report: write_report,
    convertProgram: convert, // the server has a command `kadr.convert` of its own
    chooseControl: choose_control,
    restart,
  };
  for (const [name, command] of Object.entries(commands))
    context.subscriptions.push(vscode.commands.registerCommand(`kadr.${name}`, () => command().catch(tell)));
  const colour = (document: vscode.TextDocument): void => void set_language(document, known);
  context.subscriptions.push(
    ...debugging(),
    tasks(),
    vscode.workspace.onDidOpenTextDocument(colour),
    vscode.workspace.onDidChangeConfiguration(async (e) => {
      if (!e.affectsConfiguration("kadr")) return;
      if (e.affectsConfiguration("kadr.path")) await restart();
      else await server.tell_settings();
      vscode.workspace.textDocuments.forEach(colour);
    }),
  );
  await server.start(known);
  vscode.workspace.textDocuments.forEach(colour);
}

export async function deactivate(): Promise<void> {
  await server.stop();
}

/// Gives a program the colours of its control, unless the user or the name of the file has chosen others.
async function set_language(document: vscode.TextDocument, known: string[]): Promise<void> {
  if (!is_program(document.languageId) || document.uri.scheme !== "file") return;
  const control = settings(document.uri).control || control_of_folder(document.uri.fsPath),
    language = language_of(control, known);
  if (language !== "nc" && language !== document.languageId)
    await vscode.languages.setTextDocumentLanguage(document, language);
}
