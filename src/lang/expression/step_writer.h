#pragma once
// StepWriter: the part of the compiler that reads the text and writes the steps. Used only by expression_compiler.

#include <algorithm>
#include <utility>

#include "base/ascii.h"
#include "lang/expression/expression.h"
#include "lang/text/encoding.h"

namespace kadr {

class StepWriter {
 public:
  StepWriter(Cursor& cursor, const Grammar& grammar, Block& block) : cursor_(cursor), grammar_(grammar), block_(block) {}

  /// Writes a step. `pushed`: number of values by which the step changes the height of the stack.
  Status step(Op op, double number, std::size_t begin, int pushed) {
    pushed_ += pushed;
    if (block_.code.size() >= limits::expression_steps || pushed_ > static_cast<int>(limits::expression_depth))
      return fail(alarm(AlarmId::nesting_too_deep, span(begin, begin + 1), double{limits::expression_depth}));
    block_.code.push_back({op, number, span(begin, cursor_.at)});
    return {};
  }

  /// Returns true if the bracket at the offset `begin` is not closed in the rest of the block (nct 23.2.6).
  bool is_open(std::size_t begin) const {
    int depth = 0;
    for (std::size_t i = begin; i < cursor_.text.size() && cursor_.text[i] != '('; ++i) {
      depth += cursor_.text[i] == '[' ? 1 : cursor_.text[i] == ']' ? -1 : 0;
      if (depth == 0) return false;
    }
    return true;
  }

  tl::unexpected<Alarm> wrong(std::size_t at) const {
    if (!grammar_.custom_macros) return fail(alarm(AlarmId::expression_syntax, span(at, at + 1), character_at(at)));
    if (at < cursor_.text.size() && (static_cast<unsigned char>(cursor_.text[at]) & 0x80) != 0) {
      const std::size_t bytes = std::max<std::size_t>(1, first_character(cursor_.text.substr(at)).size);
      return fail(alarm(AlarmId::unexpected_character, span(at, at + bytes), cursor_.text.substr(at, bytes)));
    }
    return fail(
        alarm(AlarmId::expression_syntax, span(at, at + 1), at < cursor_.text.size() ? cursor_.text.substr(at, 1) : std::string_view("…")));
  }

  bool named_here() {
    cursor_.skip_blanks();
    return cursor_.peek() == '<';
  }

 protected:
  /// Checks the operands of an operator on controls where a condition is not a value (spec/fanuc 5.3, 5.4). On these controls a comparison
  /// has two numbers as operands, and is allowed only in the brackets of a condition. AND, OR and XOR have two conditions or two numbers as
  /// operands; the operands of all other operators are numbers.
  Status joined(Op op, std::size_t at, bool left_is_condition) {
    if (grammar_.conditions_are_values) return {};
    const bool compares = is_comparison(op), joins = op == Op::bit_and || op == Op::bit_or || op == Op::bit_xor;
    const bool fits = joins ? left_is_condition == is_condition_ : !left_is_condition && !is_condition_ && (!compares || in_condition_);
    if (!fits) return wrong(at);
    is_condition_ = compares || (joins && is_condition_);
    return {};
  }

  /// Compiles a part of an expression that is not a condition and contains no condition.
  template <class Compile>
  Status of_numbers(Compile compile) {
    const bool in_condition = std::exchange(in_condition_, false);
    KADR_TRY(compile());
    in_condition_ = in_condition;
    is_condition_ = false;
    return {};
  }

  /// Reads [#NAME] and finds the variable to which SETVN has given this name (spec/fanuc 5.1).
  Status given_name(double& number) {
    const std::size_t open = cursor_.at;
    const std::size_t name = cursor_.text.find('#', open) + 1, close = std::min(cursor_.text.find(']', open), cursor_.text.size());
    cursor_.at = std::min(close + 1, cursor_.text.size());
    const auto known = grammar_.given_names->number_of(cursor_.text.substr(name, close - name));
    if (!known) return fail(alarm(AlarmId::too_many_words, span(open, cursor_.at), double{VariableNames::most}));
    number = *known;
    return {};
  }

  Status close(std::size_t begin) {
    cursor_.skip_blanks();
    if (cursor_.peek() != ']' && (!grammar_.custom_macros || is_open(begin)))
      return fail(alarm(AlarmId::bracket_not_closed, span(begin, begin + 1)));
    if (cursor_.peek() != ']') return wrong(cursor_.at);
    ++cursor_.at;
    return {};
  }

  /// Reads AXNUM[X], the number of an axis across all channels (nct 23.2.12).
  Status axis_number(std::size_t begin) {
    cursor_.at = begin + 5;
    cursor_.skip_blanks();
    if (cursor_.peek() != '[') return wrong(cursor_.at);
    const std::size_t open = cursor_.at++;
    cursor_.skip_blanks();
    std::string name;
    const std::size_t from = cursor_.at;
    while (cursor_.peek() != '\0' && cursor_.peek() != ']' && cursor_.peek() != ' ' && name.size() < 8)
      name += to_upper(cursor_.text[cursor_.at++]);
    const Span where = span(from, cursor_.at);
    KADR_TRY(close(open));
    const std::uint8_t axis = name.size() == 1 && name[0] >= 'A' && name[0] <= 'Z'
                                  ? grammar_.axis_numbers[static_cast<std::size_t>(name[0] - 'A')]
                                  : number_of_name(name);
    if (axis == 0) return fail(alarm(AlarmId::illegal_address, where, std::string_view(name)));
    return step(Op::number, axis, begin, 1);
  }

  std::uint8_t number_of_name(const std::string& name) const {
    for (const AddressName& row : grammar_.names)
      if (row.text == name) return grammar_.axis_numbers[static_cast<std::size_t>(row.address - 'A')];
    return 0;
  }

  const ExpressionRow* row_here(const ExpressionRows& rows, std::size_t& length) const {
    if (grammar_.short_words) return rows.find_short(rest(), length);
    const ExpressionRow* const found = rows.find(rest());
    if (found != nullptr) length = found->text.size();
    return found;
  }

  /// Returns true if the operand is a bracket […], and `/[` follows the operand, as in ATAN[a]/[b]. Then the cursor is moved to the second
  /// bracket.
  bool divides_bracket(std::size_t operand) {
    if (cursor_.text[operand] != '[') return false;
    Cursor ahead = cursor_;
    ahead.skip_blanks();
    if (ahead.peek() != '/') return false;
    ++ahead.at;
    ahead.skip_blanks();
    if (ahead.peek() != '[') return false;
    cursor_ = ahead;
    return true;
  }

  std::string_view rest() const { return cursor_.text.substr(std::min(cursor_.at, cursor_.text.size())); }

  bool starts_with(std::string_view word, std::size_t at) const {
    if (cursor_.text.size() - at < word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i)
      if (to_upper(cursor_.text[at + i]) != word[i]) return false;
    return true;
  }

  /// Returns the whole UTF-8 character that starts at this offset of the text.
  std::string_view character_at(std::size_t at) const {
    if (at >= cursor_.text.size()) return "…";
    return cursor_.text.substr(at, std::max<std::size_t>(first_character(cursor_.text.substr(at)).size, 1));
  }

  Status enter(std::size_t at) {
    if (++depth_ > static_cast<int>(limits::expression_depth))
      return fail(alarm(AlarmId::nesting_too_deep, span(at, at + 1), double{limits::expression_depth}));
    return {};
  }

  Span span(std::size_t begin, std::size_t end) const {
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::min(end, cursor_.text.size()))};
  }

  Cursor& cursor_;
  const Grammar& grammar_;
  Block& block_;
  int depth_ = 0;
  int pushed_ = 0;
  bool in_condition_ = false;  // true if a condition is allowed at the cursor; used on controls where conditions are not values
  bool is_condition_ = false;  // true if the part read last is a condition; used on controls where conditions are not values
};

}  // namespace kadr
