#pragma once
// Writes a changed number of a word in the form in which the program wrote the old one: with or without a decimal point, with leading
// zeros.

#include <optional>
#include <string>
#include <string_view>

#include "config/control/control_def.h"
#include "lang/block/block.h"

namespace kadr {

/// Returns the location of a word without blanks at its end.
inline Span without_blanks(const Block& block, Span where) {
  while (where.end > where.begin && block.text[where.end - 1] == ' ') --where.end;
  return where;
}

/// Returns the word with another value. The number has as many decimals as it needs, at most those that the control reads.
///   text     the word as the program states it: "F0120", "X-5.", "F[#1*2]"
///   value    the new value, in the unit in which Word::value is
///   returns  nullopt if the control cannot state the number: too many digits, or a sign where none is allowed
std::optional<std::string> word_with_value(std::string_view text, const Word& word, const ControlDef& def, double value);

/// Returns the word with an operation appended to the value that an expression computes: word_with_operation("F#1", "*0.8") is
/// "F[#1*0.8]".
std::string word_with_operation(std::string_view text, std::string_view operation);

}  // namespace kadr
