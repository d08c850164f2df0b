// Puts one blank between the words of each block. Used by lsp/language_server; tested by tests/lsp.py.

#include <algorithm>
#include <vector>

#include "lang/block/lexer.h"
#include "lsp/features.h"

namespace kadr {
namespace {

/// True if both blocks have the same words with the same values, so that every control executes both alike.
bool same_block(const Block& a, const Block& b) {
  const auto words = [](const Block& block) { return std::pair(block.words.begin(), block.words.begin() + block.word_count); };
  const auto same_word = [&](const Word& v, const Word& w) {
    return v.address == w.address && v.code == w.code && v.value == w.value && v.digits == w.digits && v.has_point == w.has_point;
  };
  const auto [a_begin, a_end] = words(a);
  const auto [b_begin, b_end] = words(b);
  const auto same_comment = [&](Span s, Span t) { return a.text_of(s) == b.text_of(t); };
  return a.has_number == b.has_number && a.number == b.number && a.skip == b.skip && a.main_block == b.main_block && a.marker == b.marker &&
         std::equal(a_begin, a_end, b_begin, b_end, same_word) &&
         std::equal(a.comments.begin(), a.comments.end(), b.comments.begin(), b.comments.end(), same_comment);
}

/// True if the block has only numbers as words: no expression, statement or assignment, whose blanks are left as they are.
bool is_plain(const Block& block) {
  const bool no_expression = std::none_of(block.words.begin(), block.words.begin() + block.word_count,
                                          [](const Word& w) { return bool(w.expression) || bool(w.axis) || w.where.end <= w.where.begin; });
  return no_expression && block.statement.kind == StatementKind::none && block.assignments.empty() && block.marker == Marker::none &&
         block.file_name.end == 0 && !block.broken && block.word_count > 0;
}

/// Returns the line with one blank between its words and comments. A blank inside a word is removed.
std::string spaced(std::string_view line, const Block& block) {
  std::vector<Span> parts;
  if (block.has_number) parts.push_back(block.number_where);
  for (std::uint32_t i = 0; i < block.word_count; ++i) parts.push_back(block.words[i].where);
  std::sort(parts.begin(), parts.end(), [](Span a, Span b) { return a.begin < b.begin; });
  std::string text;
  std::size_t at = 0;
  const auto add = [&](std::string_view part, bool keeps_blanks) {
    std::string written;
    for (const char c : part)
      if (keeps_blanks || (c != ' ' && c != '\t')) written += c;
    if (written.empty()) return;
    if (!text.empty() && !text.ends_with('/')) text += ' ';
    text += written;
  };
  const auto trimmed = [](std::string_view part) {
    while (!part.empty() && (part.front() == ' ' || part.front() == '\t')) part.remove_prefix(1);
    while (!part.empty() && (part.back() == ' ' || part.back() == '\t')) part.remove_suffix(1);
    return part;
  };
  for (const Span& part : parts) {
    add(trimmed(line.substr(at, part.begin - at)), true);  // a comment, or the slash of a skipped block
    add(line.substr(part.begin, part.end - part.begin), false);
    at = part.end;
  }
  add(trimmed(line.substr(at)), true);
  return text;
}

}  // namespace

LspJson formatting_json(const OpenDocument& document) {
  LspJson edits = LspJson::array();
  if (document.opened() == nullptr) return edits;
  const Grammar& grammar = document.opened()->def->grammar;
  Block before, after;
  for (std::size_t n = 0; n < document.text().lines(); ++n) {
    const std::string_view line = document.text().line(n);
    before.clear();
    const auto lexed = lex_block(line, 0, true, grammar, before);
    if (!lexed || lexed->next < line.size() || !is_plain(before)) continue;
    const std::string text = spaced(line, before);
    if (text == line) continue;
    after.clear();
    const auto again = lex_block(text, 0, true, grammar, after);
    if (!again || again->next < text.size() || !same_block(before, after)) continue;
    edits.push_back({{"range", range_json(document.text().range_of_line(n))}, {"newText", text}});
  }
  return edits;
}

}  // namespace kadr
