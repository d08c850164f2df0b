#pragma once
// Splits the text of one block into words, in one pass. No memory is allocated once the lists of the block are long enough for its words.

#include <string_view>

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/block/grammar.h"

namespace kadr {

struct Lexed {
  std::size_t next = 0;        // offset at which the text of the next block starts; text.size() at the end of the line
  bool marked = false;         // the block ended with a literal ПС or LF, not with the end of the line
  bool open_comment = false;   // A comment continues in the next line. The caller must append that line and call again.
  std::size_t comment_at = 0;  // offset at which the open comment starts
  bool continues = false;      // The block continues in the next line. The caller must append that line and call again.
  // The text has bytes above 127 outside comments and may not be UTF-8. The caller must decode the text and call again.
  bool needs_utf8 = false;
};

/// Reads the block that starts at `from`.
///   text    one line, in UTF-8 if `is_utf8`
///   block   cleared by the caller; this function sets its members, `text` and `where` included
///   alarms  each has the location of the faulty characters; the block number is set if it is written before the fault
Result<Lexed> lex_block(std::string_view text, std::size_t from, bool is_utf8, const Grammar& grammar, Block& block);

}  // namespace kadr
