#pragma once
// EditorAbilities: what the editor has said that it can do (LSP 3.17, "ClientCapabilities"). What it has not stated it cannot do.

#include "lsp/lsp_json.h"

namespace kadr {

struct EditorAbilities {
  bool code_actions = false;     // it takes actions with an edit, and not only commands
  bool applies_edits = false;    // it applies edits that the server sends
  bool versioned_edits = false;  // it takes edits with the version of the document to which they apply
  bool creates_files = false;    // an edit may create a file
  bool shows_documents = false;  // it shows a document on request
  bool nested_symbols = false;   // it takes symbols that have symbols inside
  bool wants_controls = false;   // it takes the notification kadr/control (docs/lsp.md)
  bool markdown = false;         // it shows Markdown when the pointer is on a word
};

/// Reads the capabilities of the request `initialize`.
EditorAbilities abilities_in(const LspJson& capabilities);

}  // namespace kadr
