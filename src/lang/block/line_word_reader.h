#pragma once
// LineWordReader: reads a line in the same way as Grbl. The line is filtered character by character; then words are read up to the end of
// the line (spec/grbl 1; protocol.c, gcode.c). Used by the lexer only.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "lang/block/block.h"
#include "lang/expression/expression.h"

namespace kadr {

/// Returns the characters of the line that the filter of Grbl's protocol.c keeps: in capitals, without blanks, control characters, `/`,
/// comments and real-time characters.
///   place  output: the offset in the line of each character of the result
std::string filtered(std::string_view line, std::vector<std::uint32_t>& place);

/// Returns the length of the number at the start of the text, in the notation of Grbl: a sign, digits, one decimal point. The result is 0
/// if there is no digit.
std::size_t size_of_number(std::string_view text);

/// Returns the value of a number by the rules of read_float in Grbl's nuts_bolts.c. Only the first eight digits are used, leading zeros
/// included; further digits before the decimal point are read as zeros (spec/grbl 1.3).
double value_of_digits(std::string_view number);
/// Returns the value as value_of_digits() does, but with each step of read_float rounded to 32 bits, as on the control.
float float32_of_digits(std::string_view number);

class LineWordReader {
 public:
  LineWordReader(Cursor& cursor, const Grammar& grammar, Block& block) : cursor_(cursor), grammar_(grammar), block_(block) {}

  /// Reads the whole line. A fault after some words is stored in Block::broken instead of being returned, because the control reports
  /// faults of the words before it first. The possible faults are unexpected_character, number_missing, address_unknown and too_many_words.
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
  std::string filtered_;              // the characters of the line that Grbl's filter keeps, in capitals
  std::vector<std::uint32_t> place_;  // offset in the line of each character of filtered_
};

}  // namespace kadr
