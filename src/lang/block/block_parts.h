#pragma once
// Reads the parts of a block that are not words: assignments and comments. Used by the lexer only.

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/expression/expression.h"

namespace kadr {

/// Reads `#n=value` of RS274/NGC. The cursor is after the '#', which is at `begin`.
///   alarms  those of compile_value; expression_syntax or equal_sign_missing, too_many_words
Status read_assignment(Cursor& cursor, const Grammar& grammar, Block& block, std::size_t begin);

/// Checks that a comment does not contain ПС as a separate word, because the word ПС ends the block on a tape (2С42 6.2).
///   alarms  comment_character
Status no_mark_inside(std::string_view text, std::size_t begin, std::size_t end);

}  // namespace kadr
