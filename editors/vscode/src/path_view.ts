// "Kadr: Show the path": the view of `kadr report` next to the program. It follows the cursor and moves it, and runs the
// program again when its text changes.
import { dirname, resolve } from "node:path";
import * as vscode from "vscode";
import { Follow, read_message, type FromView } from "./follow";
import { is_program } from "./languages";
import { data_of, made_report } from "./report";
import { program_of, settings, tell } from "./workspace";

const pause = 400; // ms without a change, after which the program runs again

export class PathView {
  private static shown: PathView | null = null;
  private follow = new Follow();
  private stop = new AbortController();
  private timer: NodeJS.Timeout | undefined;
  private loaded = false; // the page is in the panel; later reports replace only its data

  static async show(document: vscode.TextDocument): Promise<void> {
    if (PathView.shown) PathView.shown.panel.reveal(undefined, true);
    else {
      const panel = vscode.window.createWebviewPanel(
        "kadr.path",
        "Kadr",
        { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
        { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
      );
      PathView.shown = new PathView(panel, document);
    }
    await PathView.shown.turn_to(document);
  }

  private constructor(
    private panel: vscode.WebviewPanel,
    private document: vscode.TextDocument,
  ) {
    const listening = [
      panel.webview.onDidReceiveMessage((m) => void this.take(m)),
      vscode.window.onDidChangeTextEditorSelection((e) => {
        if (e.textEditor.document === this.document) this.post(this.follow.cursor(e.selections[0]!.active.line + 1));
      }),
      vscode.workspace.onDidChangeTextDocument((e) => {
        if (e.document === this.document && e.contentChanges.length) this.refresh_soon();
      }),
      vscode.workspace.onDidSaveTextDocument(() => this.refresh_soon()), // a set-up or a called program too
      vscode.workspace.onDidChangeConfiguration((e) => {
        if (e.affectsConfiguration("kadr")) this.refresh_soon();
      }),
      vscode.window.onDidChangeActiveTextEditor((e) => {
        if (e && is_program(e.document.languageId) && e.document.uri.scheme === "file" && e.document !== this.document)
          void this.turn_to(e.document);
      }),
    ];
    panel.onDidDispose(() => {
      PathView.shown = null;
      this.stop.abort();
      clearTimeout(this.timer);
      vscode.Disposable.from(...listening).dispose();
    });
  }

  private async turn_to(document: vscode.TextDocument): Promise<void> {
    this.document = document;
    this.panel.title = vscode.l10n.t("Path: {0}", document.uri.path.replace(/.*\//, ""));
    await this.refresh();
  }

  private refresh_soon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.refresh(), pause);
  }

  private async refresh(): Promise<void> {
    this.stop.abort();
    const stop = (this.stop = new AbortController()).signal;
    try {
      const made = await made_report(program_of(this.document), settings(this.document.uri), stop);
      if (!made || stop.aborted) return;
      if ("told" in made) return this.tell_refused(made.told);
      const text = data_of(made.html);
      if (this.loaded && text) return this.post({ kind: "report", text });
      this.panel.webview.html = made.html;
      this.loaded = true;
    } catch (e) {
      await tell(e);
    }
  }

  /// The text has no path at present: the last one stays, the findings in the editor say why.
  private tell_refused(told: string): void {
    if (this.loaded) return;
    const safe = told.replace(/[&<>]/g, (c) => `&#${c.charCodeAt(0)};`);
    this.panel.webview.html = `<!doctype html><meta http-equiv="Content-Security-Policy" content="default-src 'none'"><pre>${safe}</pre>`;
  }

  private post(message: unknown): void {
    if (message) void this.panel.webview.postMessage(message);
  }

  private async take(message: unknown): Promise<void> {
    const m = read_message(message);
    if (m?.kind === "ready") {
      const line = this.editor()?.selection.active.line ?? 0;
      this.post(this.follow.begin(line + 1));
    } else if (m) await this.move(m);
  }

  private async move(m: Extract<FromView, { kind: "line" }>): Promise<void> {
    if (m.file) return this.open_called(m.file, m.line);
    const line = this.follow.view(m.line);
    if (line === null) return;
    const editor = this.editor() ?? (m.picked ? await vscode.window.showTextDocument(this.document, 1, true) : null);
    if (editor) put_cursor(editor, line);
  }

  private async open_called(file: string, line: number): Promise<void> {
    const uri = vscode.Uri.file(resolve(dirname(this.document.uri.fsPath), file));
    try {
      const document = await vscode.workspace.openTextDocument(uri);
      put_cursor(await vscode.window.showTextDocument(document, this.editor()?.viewColumn ?? 1, true), line);
    } catch {
      // its text is inside another file or was never one
    }
  }

  private editor(): vscode.TextEditor | undefined {
    return vscode.window.visibleTextEditors.find((e) => e.document === this.document);
  }
}

function put_cursor(editor: vscode.TextEditor, line: number): void {
  const at = new vscode.Position(Math.min(line, editor.document.lineCount) - 1, 0);
  editor.selection = new vscode.Selection(at, at);
  editor.revealRange(new vscode.Range(at, at), vscode.TextEditorRevealType.InCenterIfOutsideViewport);
}
