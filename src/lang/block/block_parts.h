#pragma once
// Parts of a block that are no words. Used by the lexer only.

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/expression/expression.h"

namespace kadr {

/// `#n=value` of RS274/NGC, the cursor behind the '#' that stands at `begin`.
///   alarms  those of compile_value; expression_syntax or equal_sign_missing, too_many_words
Status read_assignment(Cursor& cursor, const Grammar& grammar, Block& block, std::size_t begin);

/// ПС as a word of its own inside a comment ends the block on the tape (2С42 6.2).
///   alarms  comment_character
Status no_mark_inside(std::string_view text, std::size_t begin, std::size_t end);

}  // namespace kadr
