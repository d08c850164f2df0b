// Reads what the editor can do. Used by lsp/language_server; tested by tests/lsp.py.

#include "lsp/editor_abilities.h"

#include <algorithm>

namespace kadr {

EditorAbilities abilities_in(const LspJson& capabilities) {
  const auto at = [&](const char* path) -> const LspJson* {
    const LspJson::json_pointer pointer(path);
    return capabilities.is_object() && capabilities.contains(pointer) ? &capabilities[pointer] : nullptr;
  };
  const auto states = [&](const char* path) {
    const LspJson* const value = at(path);
    return value != nullptr && value->is_boolean() && value->get<bool>();
  };
  const auto lists = [&](const char* path, const char* wanted) {
    const LspJson* const list = at(path);
    return list != nullptr && list->is_array() && std::find(list->begin(), list->end(), wanted) != list->end();
  };
  EditorAbilities abilities;
  abilities.code_actions = at("/textDocument/codeAction/codeActionLiteralSupport") != nullptr;
  abilities.applies_edits = states("/workspace/applyEdit");
  abilities.versioned_edits = states("/workspace/workspaceEdit/documentChanges");
  abilities.creates_files = abilities.versioned_edits && lists("/workspace/workspaceEdit/resourceOperations", "create");
  abilities.shows_documents = states("/window/showDocument/support");
  abilities.nested_symbols = states("/textDocument/documentSymbol/hierarchicalDocumentSymbolSupport");
  abilities.wants_controls = states("/experimental/kadrControl");
  abilities.markdown = lists("/textDocument/hover/contentFormat", "markdown");
  return abilities;
}

}  // namespace kadr
