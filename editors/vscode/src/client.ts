// The language server `kadr lsp`.
import * as vscode from "vscode";
import { LanguageClient, TransportKind, type StaticFeature } from "vscode-languageclient/node";
import { is_program, language_found } from "./languages";
import { server_settings } from "./settings";
import { settings, tell } from "./workspace";

/// What the server tells of a program (docs/lsp.md).
interface ControlOfProgram {
  uri: string;
  control: string; // its id; empty: none is known
}

/// Asks the server for the notification `kadr/control`.
const wants_controls: StaticFeature = {
  fillClientCapabilities: (capabilities) => {
    capabilities.experimental = { ...capabilities.experimental, kadrControl: true };
  },
  initialize: () => undefined,
  getState: () => ({ kind: "static" }),
  clear: () => undefined,
};

/// By document: the control whose colours it was given. A user who chooses other ones afterwards keeps them.
const given = new Map<string, string>();

async function colour(found: ControlOfProgram, known: string[]): Promise<void> {
  const uri = vscode.Uri.parse(found.uri).toString();
  const document = vscode.workspace.textDocuments.find((one) => one.uri.toString() === uri);
  if (!document || given.get(uri) === found.control) return;
  given.set(uri, found.control);
  const language = language_found(document.languageId, found.control, known);
  if (language !== document.languageId) await vscode.languages.setTextDocumentLanguage(document, language);
}

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
    client.registerFeature(wants_controls);
    client.onNotification("kadr/control", (found: ControlOfProgram) => void colour(found, languages));
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
