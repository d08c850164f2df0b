#pragma once
// StatementReader: reads statements of custom macros: IF, WHILE, DO, END,
// GOTO, #n=…, output (spec/nct/23 23.2, 23.5). Used by the lexer only.

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/block/grammar.h"
#include "lang/expression/expression.h"

namespace kadr {

/// The words that start a statement, or that are used in place of an address.
enum class Keyword : std::uint8_t {
  none,
  if_,
  while_,
  do_,
  end_,
  goto_,
  then_,
  open_port,
  close_port,
  open_file,
  close_file,
  print_binary,
  print_decimal,
  prm,
  names
};

class StatementReader {
 public:
  StatementReader(Cursor& cursor, const Grammar& grammar, Block& block) : cursor_(cursor), grammar_(grammar), block_(block) {}

  /// Returns the keyword at the cursor. The cursor does not move.
  Keyword keyword_here() const;
  Keyword keyword_here(std::size_t& length) const;
  /// Returns true if this control has the keyword. If not, the text is read as a word.
  bool knows(Keyword keyword) const { return keyword != Keyword::none && (keyword != Keyword::names || grammar_.semicolon_ends); }
  /// Reads a statement at the cursor, up to the end of the block or to a comment.
  ///   alarms  expression_syntax, terminator_wrong, while_without_do, do_number, illegal_address, statement_not_alone
  Status read(Keyword keyword);
  /// Reads `[#NAME]=5`. If the control allows conditions without IF, also reads such a condition.
  Status bracket();
  /// Reads `#n=…`. The cursor is after the '#'. `begin`: offset of the '#'.
  Status assignment(std::size_t begin);

 private:
  Status branch();
  Status condition();
  Status loop_while(std::size_t begin);
  Status loop_do(std::size_t begin);
  Status loop_end(std::size_t begin);
  Status loop_number(std::size_t begin);
  Status jump(std::size_t begin);
  Status device(Keyword keyword, std::size_t begin);
  Status variable_names(std::size_t begin);
  Status print(Keyword keyword, std::size_t begin);
  Status file_of_program();
  bool words_here();
  Status ended(std::size_t begin);
  tl::unexpected<Alarm> syntax(std::size_t at) const;
  Span span(std::size_t begin, std::size_t end) const;

  Cursor& cursor_;
  const Grammar& grammar_;
  Block& block_;
};

}  // namespace kadr
