#pragma once
// How a control writes operations: rows of its file ([expressions]).

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lang/expression/operation.h"

namespace kadr {

/// How a function's operand is written.
enum class Operand : std::uint8_t {
  bracket,  // SIN[…]
  value,    // SIN #1, SIN[…]: the value after it, with its signs
  pair,     // ATAN[…]/[…]
};

struct ExpressionRow {
  std::string text;  // upper case
  Op op = Op::number;
  std::uint8_t binding = 0;            // of an operator: how tightly; 0: known, but not on this control: an alarm names it
  Operand operand = Operand::bracket;  // of a function
  Op of_two = Op::number;              // of ATAN[a]/[b], where ATAN[a] is a function too; number: none
};

/// Rows by their texts. Where one text begins another, the longer one is meant.
class ExpressionRows {
 public:
  static constexpr std::size_t most = 64;
  void add(ExpressionRow row);
  bool has(std::string_view text) const;
  /// Every row of the one operation does the other.
  void replace(Op operation, Op by) {
    for (ExpressionRow& row : rows_) {
      if (row.op == operation) row.op = by;
      if (row.of_two == operation) row.of_two = by;
    }
  }
  /// Is one of these operators a comparison?
  bool compare() const;
  const std::vector<ExpressionRow>& all() const { return rows_; }
  /// The row that the text begins with, small letters like capitals; nullptr: none.
  const ExpressionRow* find(std::string_view text) const;
  /// The same; of a row of letters two may stand for all (`SI[30]`, spec/fanuc 5.4). `length`: of what is written.
  const ExpressionRow* find_short(std::string_view text, std::size_t& length) const;

 private:
  std::vector<ExpressionRow> rows_;        // by first character, the longest first
  std::array<std::uint8_t, 128> first_{};  // by first character: place of its first row, plus 1; 0: none
};

struct ExpressionRules {
  ExpressionRows operators, functions;
  ExpressionRows relations;  // between the brackets of a condition of custom macros
};

}  // namespace kadr
