#pragma once
// A line that is read by itself: filtered character by character, then words to its end (spec/grbl 1; protocol.c, gcode.c). Used by the
// lexer only.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/expression/expression.h"

namespace kadr {

/// What passes the filter of protocol.c, in capitals: no blanks, control characters, `/`, comments, real-time characters.
///   place  of each of those characters in the line
std::string filtered(std::string_view line, std::vector<std::uint32_t>& place);

/// How many characters at the beginning are a number of Grbl: a sign, digits, one point. 0: it has no digit.
std::size_t size_of_number(std::string_view text);

/// read_float of nuts_bolts.c: of the digits, leading zeros too, the first eight count; further ones before the point are zeros (1.3).
double value_of_digits(std::string_view number);
/// The same as the control has it: each step of read_float rounded to 32 bits.
float single_of_digits(std::string_view number);

class LineWordReader {
 public:
  LineWordReader(Cursor& cursor, const Grammar& grammar, Block& block) : cursor_(cursor), grammar_(grammar), block_(block) {}

  /// The whole line. What is wrong behind some words becomes Block::broken, for they count first:
  /// unexpected_character, number_missing, address_unknown, too_many_words.
  ///   alarms  block_too_long
  Status read();

 private:
  void words(std::size_t from);
  bool word(std::size_t& at);
  void add(char letter, std::string_view number, Span where);
  bool takes_number(std::string_view number);
  void code_of(Word& w) const;
  Span span(std::size_t begin, std::size_t end) const;

  Cursor& cursor_;
  const Grammar& grammar_;
  Block& block_;
  std::string kept_;                  // what passes the filter, in capitals
  std::vector<std::uint32_t> place_;  // of each character of it in the line
};

}  // namespace kadr
