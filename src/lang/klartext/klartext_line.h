#pragma once
// Reads a line of a conversational control (spec/heidenhain 1): block skip, block number, comment, continuation. A straight line whose
// words are plain numbers becomes words of the block, as on a control with word addresses; every other statement is kept as text, and read
// when it is executed. Used by lang/block/lexer only.

#include <string_view>

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/block/lexer.h"

namespace kadr {

/// Reads the block that starts at `from`; the text has several lines if the block goes on behind `~`. Asks for UTF-8 if the text has bytes
/// above 127, and for the next line if the last one ends with `~`.
Result<Lexed> lex_klartext_line(std::string_view text, std::size_t from, bool is_utf8, Block& block);

}  // namespace kadr
