#pragma once
// The features of the language server: each function answers one kind of request about a document, as JSON (LSP 3.17, "Language Features").

#include <deque>
#include <functional>

#include "lsp/lsp_json.h"
#include "lsp/open_document.h"
#include "lsp/program_folder.h"

namespace kadr {

/// Returns what the server can do. `encoding`: the unit of columns, "utf-8", "utf-16" or "utf-32".
LspJson capabilities_json(const char* encoding);

// ---- diagnostics.cpp
LspJson diagnostics_json(const OpenDocument& document);
/// Returns the corrections of the findings in the range.
LspJson actions_json(const OpenDocument& document, const TextRange& range);

// ---- hover.cpp
/// Returns the text of the word at the position, and the position of the tool after the line; null if Kadr knows nothing of it.
///   markdown  the editor shows Markdown; else it is plain text
LspJson hover_json(const OpenDocument& document, const TextPosition& position, bool markdown);
/// Returns the words that the code before the position takes, as the parameters of a call.
LspJson signature_json(const OpenDocument& document, const TextPosition& position);

// ---- completion.cpp
/// Proposes codes, addresses, variables and the numbers of blocks and subprograms, by what stands before the position.
LspJson completion_json(const OpenDocument& document, const TextPosition& position);

// ---- navigation.cpp
/// The programs of the folder of a document, and which of them the document is.
struct FolderView {
  std::deque<ProgramFileNames> open;              // the open documents; a deque, because `programs` points to them
  std::vector<const ProgramFileNames*> programs;  // the open documents, and the files that are not open
  std::size_t own = 0;
};
/// A function of the caller that reads the folder of the document; called only if the answer depends on it. `wide`: with the programs of
/// the other folders that the editor shows.
using FolderOf = std::function<FolderView(bool wide)>;
/// Returns where the name at the position is defined, in this document, else in another program of its folder, else in those of the other
/// folders.
LspJson definition_json(const OpenDocument& document, const TextPosition& position, const FolderOf& folder);
/// Returns all places of the name. Places in other programs of the folder belong to it if their calls run the same program.
///   with_definition  returns the places of definition_json() too
LspJson references_json(const OpenDocument& document, const TextPosition& position, bool with_definition, const FolderOf& folder);
LspJson highlights_json(const OpenDocument& document, const TextPosition& position);
LspJson renamed_place_json(const OpenDocument& document, const TextPosition& position);
/// Renames a variable, label, block or subprogram at all its places in this document.
///   throws  LspFault if the new name has another form, or if it has a meaning already
LspJson rename_json(const OpenDocument& document, const TextPosition& position, const std::string& name);

// ---- outline.cpp
/// Returns the programs of the document, with what each tool does in them. `nested`: as DocumentSymbol; else as a list of
/// SymbolInformation.
LspJson symbols_json(const OpenDocument& document, bool nested);
void add_workspace_symbols(const OpenDocument& document, const std::string& query, LspJson& to);
/// Adds the programs that a file of a folder defines.
void add_file_symbols(const ProgramFileNames& file, const std::string& query, LspJson& to);
LspJson folding_json(const OpenDocument& document);
/// Returns the end points of the motions of the lines in the range, as hints behind the lines.
LspJson hints_json(const OpenDocument& document, const TextRange& range);
/// Returns the time of each operation, above its first line.
LspJson lenses_json(const OpenDocument& document);

// ---- tokens.cpp
/// Returns the colours of the words, of the lines in the range or of all.
LspJson tokens_json(const OpenDocument& document, const std::optional<TextRange>& range = {});
LspJson token_legend_json();

// ---- formatting.cpp
/// Returns the changes that put one blank between the words of each block.
///   throws  LspFault if the new text would not do the same
LspJson formatting_json(const OpenDocument& document);

}  // namespace kadr
