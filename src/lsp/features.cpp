// What the language server can do. Used by lsp/language_server.

#include "lsp/features.h"

#include "lsp/proven_commands.h"

namespace kadr {

LspJson capabilities_json(const char* encoding) {
  constexpr int incremental = 2;  // LSP 3.17, "TextDocumentSyncKind"
  return {{"positionEncoding", encoding},
          {"textDocumentSync", {{"openClose", true}, {"change", incremental}, {"save", {{"includeText", false}}}}},
          {"hoverProvider", true},
          {"completionProvider", {{"triggerCharacters", {"#", "G", "M", "P", "O", "T"}}}},
          {"signatureHelpProvider", {{"triggerCharacters", {" "}}}},
          {"definitionProvider", true},
          {"referencesProvider", true},
          {"documentHighlightProvider", true},
          {"documentSymbolProvider", true},
          {"workspaceSymbolProvider", true},
          {"workspace", {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}}}},
          {"foldingRangeProvider", true},
          {"inlayHintProvider", true},
          {"codeActionProvider", {{"codeActionKinds", {"quickfix", "refactor.rewrite"}}}},
          {"executeCommandProvider", {{"commands", {convert_command, renumber_command}}}},
          {"codeLensProvider", {{"resolveProvider", false}}},
          {"documentFormattingProvider", true},
          {"renameProvider", {{"prepareProvider", true}}},
          {"semanticTokensProvider", {{"legend", token_legend_json()}, {"full", true}, {"range", true}}}};
}

}  // namespace kadr
