#pragma once
// The text of one block → words. One pass, no allocation once the block's lists have grown.

#include <string_view>

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/block/grammar.h"

namespace kadr {

struct Lexed {
  std::size_t next = 0;        // where the text of the next block begins; text.size() at the end of the line
  bool marked = false;         // ended with a literal ПС or LF
  bool open_comment = false;   // a comment goes on in the next line: append it, then again
  std::size_t comment_at = 0;  // where that one begins
  bool needs_utf8 = false;     // bytes above 127 outside comments in a text not known to be UTF-8: decode, then again
};

/// Reads the block that begins at `from`.
///   text   one line, UTF-8 if `is_utf8`
///   block  cleared by the caller; its text, position and where are set here
///   alarms each names the exact characters; the block's number is set if it stands before the fault
Result<Lexed> lex_block(std::string_view text, std::size_t from, bool is_utf8, const Grammar& grammar, Block& block);

}  // namespace kadr
