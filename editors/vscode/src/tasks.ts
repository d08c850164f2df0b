// Tasks: `kadr check` and `kadr run` of a program or folder, whose messages become problems.
import { dirname } from "node:path";
import * as vscode from "vscode";
import { is_program } from "./languages";
import { task_words, type TaskWords } from "./settings";
import { settings } from "./workspace";

type Definition = vscode.TaskDefinition & TaskWords;
const matchers = ["$kadr-alarm", "$kadr-warning", "$kadr-note"];

export function task_of(d: Definition, folder?: vscode.WorkspaceFolder): vscode.Task {
  const program = d.file ? vscode.Uri.file(d.file) : folder?.uri,
    s = settings(program);
  const cwd = folder?.uri.fsPath ?? (d.file ? dirname(d.file) : undefined);
  const name = d.file ? `${d.command} ${vscode.workspace.asRelativePath(d.file)}` : d.command;
  const run = new vscode.ProcessExecution(s.path, task_words(d, s), { cwd });
  const task = new vscode.Task(d, folder ?? vscode.TaskScope.Workspace, name, "kadr", run, matchers);
  if (d.command === "check") task.group = vscode.TaskGroup.Build;
  return task;
}

export function tasks(): vscode.Disposable {
  return vscode.tasks.registerTaskProvider("kadr", {
    provideTasks: () => {
      const document = vscode.window.activeTextEditor?.document,
        all: vscode.Task[] = [];
      if (document && is_program(document.languageId) && document.uri.scheme === "file") {
        const folder = vscode.workspace.getWorkspaceFolder(document.uri);
        for (const command of ["check", "run"] as const)
          all.push(task_of({ type: "kadr", command, file: document.uri.fsPath }, folder));
      }
      for (const folder of vscode.workspace.workspaceFolders ?? [])
        all.push(task_of({ type: "kadr", command: "check" }, folder));
      return all;
    },
    // A task of tasks.json: the definition must stay the same object.
    resolveTask: (task) =>
      task_of(task.definition as Definition, typeof task.scope === "object" ? task.scope : undefined),
  });
}
