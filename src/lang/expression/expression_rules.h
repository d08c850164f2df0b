#pragma once
// The operators and functions of a control, as rows of its file ([expressions]).

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lang/expression/operation.h"

namespace kadr {

/// The form in which the operand of a function is written.
enum class Operand : std::uint8_t {
  bracket,  // SIN[…]
  value,    // SIN #1, SIN[…]: the operand is the next value with its signs
  pair,     // ATAN[…]/[…]
};

struct ExpressionRow {
  std::string text;  // text of the operator or function in upper case
  Op op = Op::number;
  std::uint8_t binding = 0;            // priority of an operator; 0: the control does not have the operator, but an alarm can name it
  Operand operand = Operand::bracket;  // form in which the operand of a function is written
  // for ATAN, of which both ATAN[a] and ATAN[a]/[b] are functions: operation of ATAN[a]/[b]; Op::number: any other function
  Op of_two = Op::number;
};

/// Operators or functions, found by their text. If one text is the beginning of another, the longer text is found.
class ExpressionRows {
 public:
  static constexpr std::size_t most = 64;
  void add(ExpressionRow row);
  bool has(std::string_view text) const;
  /// Makes every operator or function of the rows that has the operation `operation` use the operation `by` instead.
  void replace(Op operation, Op by) {
    for (ExpressionRow& row : rows_) {
      if (row.op == operation) row.op = by;
      if (row.of_two == operation) row.of_two = by;
    }
  }
  /// Returns true if at least one operator in the rows is a comparison.
  bool compare() const;
  const std::vector<ExpressionRow>& all() const { return rows_; }
  /// Returns the row whose text is at the beginning of `text`, in any letter case; nullptr if no row matches.
  const ExpressionRow* find(std::string_view text) const;
  /// Finds a row as find() does, but the first two letters of a word are enough (`SI[30]`, spec/fanuc 5.4). Sets `length` to the length of
  /// the text that matched.
  const ExpressionRow* find_short(std::string_view text, std::size_t& length) const;

 private:
  // the operators or functions, sorted by first character; with the same first character, longer texts come first
  std::vector<ExpressionRow> rows_;
  // by character: 1 plus the index in rows_ of the first operator or function that starts with the character; 0: none
  std::array<std::uint8_t, 128> first_{};
};

struct ExpressionRules {
  ExpressionRows operators, functions;
  ExpressionRows relations;  // comparisons that are allowed in the brackets of a condition, in custom macros
};

}  // namespace kadr
