#pragma once
// Reads the beginning of a line of a control whose blocks have names: skip level, block number, label, comment (spec/sinumerik 2). The
// statement itself is kept as text, and read when it is executed, because a fault is reported only then. Used by the lexer only.

#include <string_view>

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/block/lexer.h"

namespace kadr {

/// Reads the line from `from` to its end into the block.
///   alarms  number_damaged, skip_level_wrong
Status read_named_line(std::string_view text, std::size_t from, Block& block);

/// Does the same for lex_block() (lang/block/lexer.h). Asks for UTF-8 if the line has bytes above 127.
Result<Lexed> lex_named_line(std::string_view text, std::size_t from, bool is_utf8, Block& block);

/// Returns the value of Block::skip for a level, 0 (`/` alone) to 9. The level is the value modulo 10; the value 0 means no slash.
constexpr std::uint8_t skip_of_level(int level) { return static_cast<std::uint8_t>(level == 0 ? 10 : level); }

}  // namespace kadr
