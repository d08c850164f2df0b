// Reads the parts of a block that are not words: assignments and comments. Used by lang/block/lexer.

#include "lang/block/block_parts.h"

#include <algorithm>

#include "lang/block/word_reader.h"
#include "lang/text/end_mark.h"

namespace kadr {
namespace {

Span span_of(const Cursor& cursor, std::size_t begin, std::size_t end) {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::min(end, cursor.text.size()))};
}

}  // namespace

Status read_assignment(Cursor& cursor, const Grammar& grammar, Block& block, std::size_t begin) {
  auto target = compile_target(cursor, grammar, block);
  if (!target) return fail(target.error());
  cursor.skip_blanks();
  if (cursor.peek() != '=') {
    const AlarmId id = grammar.named_variables != nullptr ? AlarmId::equal_sign_missing : AlarmId::expression_syntax;
    return fail(alarm(id, span_of(cursor, begin, cursor.at + 1), "#n="));
  }
  ++cursor.at;
  auto value = compile_value(cursor, grammar, block);
  if (!value) return fail(value.error());
  if (block.assignments.size() == limits::block_assignments)
    return fail(alarm(AlarmId::too_many_words, span_of(cursor, begin, cursor.at), double{limits::block_assignments}));
  block.assignments.push_back({*target, *value, span_of(cursor, begin, cursor.at)});
  return {};
}

/// Checks that a comment does not contain ПС as a separate word, because the word ПС ends the block on a tape (2С42 6.2).
Status no_mark_inside(std::string_view text, std::size_t begin, std::size_t end) {
  constexpr std::string_view mark = end_mark_in_text;
  const auto apart = [&](std::size_t i) { return i < begin || i >= end || is_blank(text[i]); };
  for (std::size_t i = text.find(mark, begin); i < end; i = text.find(mark, i + 1))
    if (apart(i - 1) && apart(i + mark.size()))
      return fail(
          alarm(AlarmId::comment_character, Span{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + mark.size())}, mark));
  return {};
}

}  // namespace kadr
