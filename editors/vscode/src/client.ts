// The language server `kadr lsp`.
import * as vscode from "vscode";
import { LanguageClient, TransportKind } from "vscode-languageclient/node";
import { is_program } from "./languages";
import { server_settings } from "./settings";
import { settings, tell } from "./workspace";

export class Server {
  private client: LanguageClient | null = null;

  async start(languages: string[]): Promise<void> {
    const { path } = settings();
    const client = new LanguageClient(
      "kadr",
      "Kadr",
      { command: path, args: ["lsp"], transport: TransportKind.stdio },
      {
        documentSelector: languages.filter(is_program).map((language) => ({ scheme: "file", language })),
        initializationOptions: () => server_settings(settings(vscode.window.activeTextEditor?.document.uri)),
        synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.{toml,json,tbl}") },
      },
    );
    this.client = client;
    await client.start().catch(tell);
  }

  /// The settings have changed.
  async tell_settings(): Promise<void> {
    const now = { kadr: server_settings(settings(vscode.window.activeTextEditor?.document.uri)) };
    await this.client?.sendNotification("workspace/didChangeConfiguration", { settings: now });
  }

  async stop(): Promise<void> {
    const { client } = this;
    this.client = null;
    await client?.stop().catch(() => undefined); // a server that did not start cannot be stopped
  }
}
