#pragma once
// OWordReader: reads O lines of RS274/NGC: `O100 while [#1 LT 3]`, `o<slot> call [5]` (spec/linuxcnc 6). Used by the lexer only.

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/expression/expression.h"

namespace kadr {

class OWordReader {
 public:
  OWordReader(Cursor& cursor, const Grammar& grammar, Block& block) : cursor_(cursor), grammar_(grammar), block_(block) {}

  /// Reads the whole line, from the O up to a comment, into Block::statement with the kind o_word.
  ///   alarms  those of compile_value; o_word_label, o_word_unknown, o_word_bracket, o_word_rest, o_word_arguments
  Status read();

 private:
  Status label();
  Status number();
  Status command();
  Status arguments();
  Status bracket(std::string_view after);
  Status ended();
  Span span(std::size_t begin) const { return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(cursor_.at)}; }

  Cursor& cursor_;
  const Grammar& grammar_;
  Block& block_;
};

}  // namespace kadr
