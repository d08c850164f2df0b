// The colours of a program in an editor: semantic tokens. Used by lsp/language_server; tested by tests/lsp.py.

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "lang/block/lexer.h"
#include "lsp/features.h"

namespace kadr {
namespace {

enum Type : std::uint32_t { comment, label, keyword, function, number, variable };
constexpr std::array<const char*, 6> type_names = {"comment", "label", "keyword", "function", "number", "variable"};
constexpr std::size_t longest_coloured = 10'000;  // bytes; the rest of a longer line has no colours
constexpr std::size_t most_names = 200;           // of a line; further ones have the colour of their word

enum Modifier : std::uint32_t { none = 0, definition = 1 };  // a sum of powers of two
constexpr std::array<const char*, 1> modifier_names = {"definition"};

struct Token {
  Span where;
  Type type = number;
  Modifier modifier = none;
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
  if (block.has_number) to.push_back({block.number_where, label, definition});
  if (block.marker == Marker::label) to.push_back({block.where, label, definition});
  if (block.statement.kind == StatementKind::o_word) to.push_back({block.statement.label_where, label});
  for (std::uint32_t i = 0; i < block.word_count; ++i)
    if (block.words[i].where.end > block.words[i].where.begin) to.push_back({block.words[i].where, type_of(block.words[i])});
  for (const Assignment& one : block.assignments) to.push_back({one.where, variable});
}

/// Returns the token of a name inside a word or a statement, such as the variable in X#101; nullopt if the name is coloured as its word.
std::optional<Token> token_of(const NamedPlace& place, std::string_view line) {
  Token token{place.where, label, place.defines ? definition : none};
  const char before = place.where.begin == 0 || place.where.begin > line.size() ? '\0' : line[place.where.begin - 1];
  switch (place.kind) {
    case NameKind::variable:
      token.type = variable;
      if (before == '#') --token.where.begin;
      return token;
    case NameKind::block:
    case NameKind::program:
      // The address belongs to the name where it is defined: N10, O200. Where it is referred to, the address has its own colour: P200.
      if (place.defines && std::string_view("NnOo:").find(before) != std::string_view::npos) --token.where.begin;
      return token;
    case NameKind::label: return token;
    case NameKind::tool:
    case NameKind::heading:
    case NameKind::opens:
    case NameKind::closes:
    case NameKind::section:
    case NameKind::cycle:
    case NameKind::no_cycle:
    case NameKind::remark:
    case NameKind::change:
    case NameKind::mark: break;
  }
  return std::nullopt;
}

bool overlap(const Span& a, const Span& b) { return a.begin < b.end && b.begin < a.end; }

/// Adds a token without the parts that the tokens of names cover: `X` of X#101.
void add_around(Token token, const std::vector<Token>& names, std::vector<Token>& to) {
  for (const Token& name : names) {  // in the order of the line
    if (!overlap(token.where, name.where)) continue;
    if (token.where.begin < name.where.begin) to.push_back({{token.where.begin, name.where.begin}, token.type, token.modifier});
    token.where.begin = std::min(name.where.end, token.where.end);
  }
  if (token.where.begin < token.where.end) to.push_back(token);
}

/// Returns the tokens of a line, in its order. They do not overlap. `block`: only its memory is used, since a Block is large.
std::vector<Token> tokens_of(std::string_view line, const std::vector<NamedPlace>& names, const Grammar& grammar, Block& block) {
  const auto before = [](const Token& a, const Token& b) { return a.where.begin < b.where.begin; };
  std::vector<Token> of_names, words;
  for (const NamedPlace& place : names)
    if (const auto token = token_of(place, line); token && of_names.size() < most_names) of_names.push_back(*token);
  std::stable_sort(of_names.begin(), of_names.end(), before);
  for (std::size_t from = 0; from < line.size();) {
    block.clear();
    const auto lexed = lex_block(line, from, true, grammar, block);
    take(block, words);
    if (!lexed || lexed->next <= from) break;
    from = lexed->next;
  }
  std::vector<Token> tokens = of_names;
  for (const Token& word : words) add_around(word, of_names, tokens);
  std::stable_sort(tokens.begin(), tokens.end(), before);
  std::uint32_t end = 0;
  std::erase_if(tokens, [&](const Token& token) { return token.where.begin < std::exchange(end, std::max(end, token.where.end)); });
  return tokens;
}

}  // namespace

LspJson token_legend_json() {
  return {{"tokenTypes", std::vector<std::string>(type_names.begin(), type_names.end())},
          {"tokenModifiers", std::vector<std::string>(modifier_names.begin(), modifier_names.end())}};
}

LspJson tokens_json(const OpenDocument& document, const std::optional<TextRange>& range) {
  LspJson data = LspJson::array();
  if (document.opened() == nullptr || document.names() == nullptr) return {{"data", std::move(data)}};
  const std::size_t first = range ? range->start.line : 0;
  const std::size_t end = std::min(range ? std::size_t{range->end.line} + 1 : document.text().lines(), document.text().lines());
  std::uint32_t last_line = 0;
  Block block;
  for (std::size_t n = first; n < end; ++n) {
    const std::string_view line = document.text().line(n).substr(0, longest_coloured);
    std::uint32_t last_column = 0;
    for (const Token& token : tokens_of(line, document.names()->line(n), document.opened()->def->grammar, block)) {
      if (token.where.end > line.size()) continue;
      const TextRange place = document.text().range_of(n, token.where);
      const auto at = static_cast<std::uint32_t>(n);
      for (const std::uint32_t value : {at - last_line, place.start.column - (at == last_line ? last_column : 0),
                                        place.end.column - place.start.column, std::uint32_t(token.type), std::uint32_t(token.modifier)})
        data.push_back(value);
      last_line = at, last_column = place.start.column;
    }
  }
  return {{"data", std::move(data)}};
}

}  // namespace kadr
