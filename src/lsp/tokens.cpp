// The colours of a program in an editor: semantic tokens. Used by lsp/language_server; tested by tests/lsp.py.

#include <algorithm>
#include <array>

#include "lang/block/lexer.h"
#include "lsp/features.h"

namespace kadr {
namespace {

enum Type : std::uint32_t { comment, label, keyword, function, number, variable };
constexpr std::array<const char*, 6> type_names = {"comment", "label", "keyword", "function", "number", "variable"};
constexpr std::size_t longest_coloured = 10'000;  // bytes; the rest of a longer line has no colours

struct Token {
  Span where;
  Type type = number;
};

Type type_of(const Word& word) {
  if (word.address == 'G') return keyword;
  return word.address == 'M' || word.address == 'T' ? function : number;
}

void take(const Block& block, std::vector<Token>& to) {
  for (const Span& where : block.comments) {
    // the brackets, or the sign that begins the comment, belong to it
    const std::uint32_t begin = where.begin == 0 ? 0 : where.begin - 1;
    const bool closed = where.end < block.text.size() && block.text[where.end] == ')';
    to.push_back({{begin, where.end + (closed ? 1 : 0)}, comment});
  }
  if (block.has_number) to.push_back({block.number_where, label});
  if (block.marker == Marker::label) to.push_back({block.where, label});
  if (block.statement.kind == StatementKind::o_word) to.push_back({block.statement.label_where, label});
  for (std::uint32_t i = 0; i < block.word_count; ++i)
    if (block.words[i].where.end > block.words[i].where.begin) to.push_back({block.words[i].where, type_of(block.words[i])});
  for (const Assignment& one : block.assignments) to.push_back({one.where, variable});
}

}  // namespace

LspJson token_legend_json() {
  return {{"tokenTypes", std::vector<std::string>(type_names.begin(), type_names.end())}, {"tokenModifiers", LspJson::array()}};
}

LspJson tokens_json(const OpenDocument& document) {
  LspJson data = LspJson::array();
  if (document.opened() == nullptr) return {{"data", std::move(data)}};
  const Grammar& grammar = document.opened()->def->grammar;
  std::uint32_t last_line = 0;
  std::vector<Token> tokens;
  Block block;
  for (std::size_t n = 0; n < document.text().lines(); ++n) {
    const std::string_view line = document.text().line(n).substr(0, longest_coloured);
    tokens.clear();
    for (std::size_t from = 0; from < line.size();) {
      block.clear();
      const auto lexed = lex_block(line, from, true, grammar, block);
      take(block, tokens);
      if (!lexed || lexed->next <= from) break;
      from = lexed->next;
    }
    std::stable_sort(tokens.begin(), tokens.end(), [](const Token& a, const Token& b) { return a.where.begin < b.where.begin; });
    std::uint32_t last_column = 0, end = 0;
    for (const Token& token : tokens) {
      if (token.where.begin < end || token.where.end > line.size()) continue;  // tokens must not overlap
      end = token.where.end;
      const TextRange range = document.text().range_of(n, token.where);
      const auto at = static_cast<std::uint32_t>(n);
      for (const std::uint32_t value : {at - last_line, range.start.column - (at == last_line ? last_column : 0),
                                        range.end.column - range.start.column, std::uint32_t(token.type), 0U})
        data.push_back(value);
      last_line = at, last_column = range.start.column;
    }
  }
  return {{"data", std::move(data)}};
}

}  // namespace kadr
