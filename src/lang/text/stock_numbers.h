#pragma once
// The numbers of a comment about a blank, with their units and fractions. Only lang/text uses this file.

#include <cstddef>
#include <string_view>
#include <vector>

#include "lang/text/tool_comment_tokens.h"

namespace kadr {

inline constexpr double inch_in_mm = 25.4;
inline constexpr double greatest_blank = 10'000;  // mm; no blank is larger

struct StockNumber {
  double value = 0;                // in mm if it has a unit, else in the unit of the comment
  double unit = 0;                 // mm per unit of the unit that it has; 0: none
  std::size_t first = 0, end = 0;  // tokens of the number with its unit
  /// Returns the number in mm. `other`: mm per unit of a number without a unit.
  double mm(double other) const { return unit > 0 ? value : value * other; }
};

/// Returns the numbers of a comment, each with the fraction after it (5-1/2) and its unit.
std::vector<StockNumber> stock_numbers(const std::vector<CommentToken>& tokens);

/// True if `words`, separated by blanks, contains the word.
bool is_one_of(std::string_view words, std::string_view word);

}  // namespace kadr
