// What an editor shows about the word under the pointer, and about the words that a code takes. Used by lsp/language_server; tested by
// tests/lsp.py.

#include <fmt/format.h>

#include <algorithm>

#include "config/texts.h"
#include "lsp/features.h"
#include "out/text/explain/line_words.h"
#include "out/text/explain/word_text.h"
#include "out/text/in_language.h"
#include "texts/lsp.h"

namespace kadr {
namespace {

constexpr std::size_t longest_shown = 10'000;  // bytes of a line

/// Returns the words of a line, with their columns in characters counted from 1.
std::vector<LineWord> words_at(const OpenDocument& document, std::size_t line) {
  const OpenedProgram& opened = *document.opened();
  return words_of_line(*opened.def, *opened.texts, document.text().line(line).substr(0, longest_shown), document.lang());
}

/// Returns the position of the tool after a line, such as "X10 Y-2.5 Z0, F200 mm/min".
std::string result_text(const OpenDocument& document, const LineResult& result) {
  const ControlDef& def = *document.opened()->def;
  std::string text;
  for (std::size_t axis = 0; axis < std::min(def.axes.size(), max_axes); ++axis)
    text += fmt::format("{}{} {:.4g}", text.empty() ? "" : "  ", def.axes[axis], result.to[axis] + 0.0);
  std::string whole = translated_in(document.lang(), texts::lsp::tool_after_line, text);
  if (result.feed > 0) whole += translated_in(document.lang(), texts::lsp::feed_of_line, fmt::format("{:.4g}", result.feed));
  return whole;
}

}  // namespace

LspJson hover_json(const OpenDocument& document, const TextPosition& position, bool markdown) {
  if (document.opened() == nullptr || position.line >= document.text().lines()) return nullptr;
  const TextDocument& text = document.text();
  const std::uint32_t column = std::min(position.column, text.range_of_line(position.line).end.column);
  std::string shown;
  TextRange range{{position.line, column}, {position.line, column}};
  for (const LineWord& word : words_at(document, position.line)) {
    const std::uint32_t from = text.column_of_character(position.line, word.from), to = text.column_of_character(position.line, word.to);
    if (column < from || column >= to) continue;
    shown = word.text.empty() ? word.code + "  " + word.title : word.text;
    range = {{position.line, from}, {position.line, to}};
  }
  const LineResult* const result = document.result(position.line);
  if (shown.empty() && result == nullptr) return nullptr;
  if (markdown && !shown.empty()) shown = fmt::format("```text\n{}\n```", shown);
  if (result != nullptr) shown += (shown.empty() ? "" : "\n\n") + result_text(document, *result);
  return {{"contents", {{"kind", markdown ? "markdown" : "plaintext"}, {"value", shown}}}, {"range", range_json(range)}};
}

LspJson signature_json(const OpenDocument& document, const TextPosition& position) {
  if (document.opened() == nullptr || position.line >= document.text().lines()) return nullptr;
  const ControlDef& def = *document.opened()->def;
  const CodeRow* code = nullptr;
  std::string last;  // the last word before the position
  for (const LineWord& word : words_at(document, position.line)) {
    if (document.text().column_of_character(position.line, word.from) >= position.column) break;
    last = word.code;
    const auto row = std::find_if(def.codes.begin(), def.codes.end(), [&](const CodeRow& r) { return r.code == word.code; });
    if (row != def.codes.end() && row->takes != 0) code = &*row;
  }
  if (code == nullptr) return nullptr;
  std::string label = code->code;
  LspJson parameters = LspJson::array();
  int active = -1;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((code->takes & letter_bit(letter)) == 0) continue;
    label += fmt::format(" {}", letter);
    const auto end = static_cast<unsigned>(label.size());
    if (last == std::string(1, letter)) active = static_cast<int>(parameters.size());
    parameters.push_back({{"label", {end - 1, end}}, {"documentation", meaning_of(def, *code, letter, document.lang())}});
  }
  LspJson signature = {
      {"label", label}, {"documentation", in_language(code->text, document.lang())}, {"parameters", std::move(parameters)}};
  LspJson json = {{"signatures", LspJson::array({std::move(signature)})}, {"activeSignature", 0}};
  if (active >= 0) json["activeParameter"] = active;
  return json;
}

}  // namespace kadr
