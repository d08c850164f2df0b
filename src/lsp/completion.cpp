// What an editor proposes while a word is written. Used by lsp/language_server; tested by tests/lsp.py.

#include <algorithm>
#include <set>

#include "base/ascii.h"
#include "config/texts.h"
#include "lsp/features.h"
#include "out/text/in_language.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr int item_function = 3, item_variable = 6, item_keyword = 14, item_reference = 18;  // LSP 3.17, "CompletionItemKind"
constexpr std::size_t max_items = 2000;

/// Returns the beginning of the word that ends at a byte of the line: a letter with the number after it, or `#` with a number or name.
std::size_t begin_of_word(std::string_view line, std::size_t end) {
  std::size_t at = end;
  while (at > 0 && (is_digit(line[at - 1]) || line[at - 1] == '.' || line[at - 1] == '_' || line[at - 1] == '<')) --at;
  if (at > 0 && (is_capital(to_upper(line[at - 1])) || line[at - 1] == '#')) --at;
  return at;
}

class Proposals {
 public:
  Proposals(const OpenDocument& document, const TextRange& replaced) : document_(document), replaced_(replaced) {}

  void add(const std::string& text, const std::string& what, int kind) {
    if (items_.size() < max_items && seen_.insert(text).second)
      items_.push_back(
          {{"label", text}, {"detail", what}, {"kind", kind}, {"textEdit", {{"range", range_json(replaced_)}, {"newText", text}}}});
  }

  void add_codes(const ControlDef& def, char letter) {
    for (const CodeRow& row : def.codes)
      if (row.works && (letter == 0 || row.letter == letter)) add(row.code, in_language(row.text, document_.lang()), item_function);
  }
  void add_addresses(const ControlDef& def) {
    for (char letter = 'A'; letter <= 'Z'; ++letter)
      if (const AddressRow& row = def.address(letter); row.function != Function::count)
        add(std::string(1, letter), in_language(row.text, document_.lang()), item_keyword);
  }
  /// Proposes names of a kind that the document defines, written after `before`.
  void add_names(NameKind kind, const std::string& before) {
    const DocumentNames& names = *document_.names();
    for (std::size_t n = 0; n < names.lines(); ++n)
      for (const NamedPlace& place : names.line(n))
        if (place.kind == kind && (place.defines || kind == NameKind::variable || kind == NameKind::tool))
          add(before + place.name, translated_in(document_.lang(), texts::lsp::in_line, n + 1),
              kind == NameKind::variable ? item_variable : item_reference);
  }
  void add_system_variables(const ControlDef& def) {
    for (const VariableRow& row : def.variables)
      if (row.works && !row.symbol.empty()) add("#_" + row.symbol, in_language(row.text, document_.lang()), item_variable);
  }
  LspJson all() { return {{"isIncomplete", items_.size() >= max_items}, {"items", std::move(items_)}}; }

 private:
  const OpenDocument& document_;
  const TextRange replaced_;
  std::set<std::string> seen_;
  LspJson items_ = LspJson::array();
};

}  // namespace

LspJson completion_json(const OpenDocument& document, const TextPosition& position) {
  if (document.opened() == nullptr || position.line >= document.text().lines()) return nullptr;
  const ControlDef& def = *document.opened()->def;
  const std::string_view line = document.text().line(position.line);
  const std::size_t end = document.text().byte_of(position), begin = begin_of_word(line, end);
  Proposals proposals(document, document.text().range_of(position.line, {std::uint32_t(begin), std::uint32_t(end)}));
  const char first = begin < end ? to_upper(line[begin]) : '\0';
  if (first == '#') {
    proposals.add_names(NameKind::variable, "#");
    proposals.add_system_variables(def);
  } else if (first == 'G' || first == 'M') {
    proposals.add_codes(def, first);
  } else if (first == 'P') {
    proposals.add_names(NameKind::program, "P");
    proposals.add_names(NameKind::block, "P");
  } else if (first == 'O') {
    proposals.add_names(NameKind::program, "O");
    proposals.add_names(NameKind::label, "O");
  } else if (first == 'T') {
    proposals.add_names(NameKind::tool, "T");
  } else if (first == '\0') {
    proposals.add_addresses(def);
    proposals.add_codes(def, 0);
  }
  return proposals.all();
}

}  // namespace kadr
