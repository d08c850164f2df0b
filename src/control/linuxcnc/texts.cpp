// LinuxCNC's own texts for faults that the block reader, or functions used by several controls, find (spec/linuxcnc 2 to 5, 11). In
// LinuxCNC an alarm has no number; its English text identifies it.

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/ascii.h"
#include "control/block_context.h"
#include "control/linuxcnc/linuxcnc.h"
#include "lang/text/encoding.h"

namespace kadr::linuxcnc {
namespace {

struct Words {
  AlarmId id;
  std::string text;
};

bool begins(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (to_upper(text[i]) != word[i]) return false;
  return true;
}

char small(char c) { return is_capital(c) ? static_cast<char>(c | 0x20) : c; }

/// Returns the rest of the program line, from the location of the alarm to the end of the line.
std::string_view there(const AlarmReport& report) {
  const Span at = report.alarm.where;
  const std::string_view line = report.line_text;
  return at.begin < line.size() ? line.substr(at.begin) : std::string_view();
}

std::string argument(const AlarmReport& report, std::size_t nth) {
  return nth < report.alarm.arg_count && !report.alarm.args[nth].is_number() ? std::string(report.alarm.args[nth].text()) : std::string();
}

Words bad_character(const AlarmReport& report) {
  const std::string_view at = there(report);
  const char c = at.empty() ? ' ' : at[0];
  const auto code = static_cast<unsigned char>(c);
  if (code < 0x20 || code > 0x7E) return {AlarmId::rs274_form, fmt::format("Bad character '\\{:03o}' used", code)};
  return {AlarmId::rs274_form, fmt::format("Bad character '{}' used", small(c))};
}

/// Returns LinuxCNC's text for a word without a value (spec/linuxcnc 2.3).
Words no_value(const AlarmReport& report) {
  const std::string letter = argument(report, 0);
  if (letter == "N") return {AlarmId::rs274_form, "Bad format unsigned integer"};
  const std::string_view at = there(report);
  const std::size_t letter_bytes =
      std::max<std::size_t>(first_character(at).size, 1);  // a Russian letter that looks like a Latin letter has two bytes
  const std::size_t after = at.find_first_not_of(" \t", letter_bytes);
  if (after == std::string_view::npos || at[after] == '(' || at[after] == ';')
    return {AlarmId::rs274_form, "No characters found in reading real value"};
  return {AlarmId::rs274_form, fmt::format("bad number format (conversion failed) parsing '{}'", at.substr(after))};
}

/// Returns the number that is written at the alarm's location (digits, decimal points, signs). The location may be the start or the end of
/// the number.
std::string_view number_there(const AlarmReport& report) {
  constexpr std::string_view of_numbers = "0123456789.+-";
  const std::string_view line = report.line_text;
  std::size_t begin = std::min<std::size_t>(report.alarm.where.begin, line.size()), end = begin;
  while (begin > 0 && of_numbers.find(line[begin - 1]) != std::string_view::npos) --begin;
  if (begin == end)
    while (begin < line.size() && of_numbers.find(line[begin]) == std::string_view::npos) ++begin;
  end = std::max(begin, end);
  while (end < line.size() && of_numbers.find(line[end]) != std::string_view::npos) ++end;
  return line.substr(begin, end - begin);
}

Words number_wrong(const AlarmReport& report) {
  const std::string_view number = number_there(report);
  const std::string_view line = report.line_text;
  const std::size_t begin = static_cast<std::size_t>(number.data() - line.data());
  if (begin > 0 && small(line[begin - 1]) == 'n') return {AlarmId::rs274_form, "Bad character '.' used"};
  const bool digits = number.find_first_of("0123456789") != std::string_view::npos;
  return {AlarmId::rs274_form,
          fmt::format("bad number format ({}) parsing '{}'", digits ? "trailing characters" : "conversion failed", number)};
}

/// Returns true if the line ends at a position where a value must follow.
bool lacks_value(std::string_view line) {
  if (const std::size_t semicolon = line.find(';'); semicolon != std::string_view::npos) line = line.substr(0, semicolon);
  const std::size_t last = line.find_last_not_of(" \t\r");
  constexpr std::string_view before_values = "[+-*/=#";
  return last == std::string_view::npos || before_values.find(line[last]) != std::string_view::npos || is_letter(line[last]);
}

Words function_wrong(const AlarmReport& report) {
  constexpr std::string_view begin_functions = "acefflrst";
  const std::string_view at = there(report);
  const char c = at.empty() ? ' ' : small(at[0]);
  if (begin_functions.find(c) != std::string_view::npos)
    return {AlarmId::rs274_expression, fmt::format("Unknown word starting with {}", c)};
  return {AlarmId::rs274_expression, "Unknown word where unary operation could be"};
}

Words operator_wrong(const AlarmReport& report) {
  constexpr std::string_view begin_operators = "amoxengl";
  const std::string_view at = there(report);
  const char c = at.empty() ? ' ' : small(at[0]);
  if (begin_operators.find(c) != std::string_view::npos)
    return {AlarmId::rs274_expression, fmt::format("Unknown operation name starting with {}", c)};
  return {AlarmId::rs274_expression, "Unknown operation"};
}

Words no_number(const AlarmReport& report) {
  const std::string_view at = there(report);
  if (begins(at, "SQRT")) return {AlarmId::rs274_expression, "Negative argument to sqrt"};
  if (begins(at, "LN")) return {AlarmId::rs274_expression, "Zero or negative argument to ln"};
  if (begins(at, "ACOS")) return {AlarmId::rs274_expression, "Argument to acos out of range"};
  if (begins(at, "ASIN")) return {AlarmId::rs274_expression, "Argument to asin out of range"};
  return {AlarmId::rs274_expression, "Calculation resulted in 'infinity'"};
}

Words expression_wrong(const AlarmReport& report) {
  const std::string of = argument(report, 0);
  const std::string_view line = report.line_text;
  if (of.find("]/[") != std::string::npos)
    return {AlarmId::rs274_expression, line.find("]/") != std::string_view::npos ? "Left bracket missing after slash with atan"
                                                                                 : "Slash missing after first atan argument"};
  const bool over = begins(there(report), "[") || of == "…";
  if (over && lacks_value(line)) return {AlarmId::rs274_form, "No characters found in reading real value"};
  if (over) return {AlarmId::rs274_expression, "Unclosed expression"};
  const std::size_t at = report.alarm.where.begin;
  if (at > 0 && at <= line.size() && (line[at - 1] == '#' || begins(there(report), "#")))
    return {AlarmId::rs274_form, "bad number format (conversion failed) parsing ''"};
  return {AlarmId::rs274_expression, "Unknown operation"};
}

std::string function_name(std::string_view at) {
  std::string name;
  for (const char c : at) {
    if (!is_letter(c)) break;
    name += to_upper(c);
  }
  return name;
}

// NOLINTNEXTLINE(readability-function-size): a table
Words own_words(const AlarmReport& report, const ExpressionRules& rules) {
  const std::string letter = argument(report, 0);
  switch (report.alarm.id) {
    case AlarmId::address_twice:
      if (letter == "N") return {AlarmId::rs274_form, "Bad character 'n' used"};
      if (letter == "$") return {AlarmId::rs274_form, "Multiple spindle choice ($) words on one line"};
      if (letter == "U" || letter == "V" || letter == "W")
        return {AlarmId::rs274_form, fmt::format("Multiple {} words on one line", letter)};
      return {AlarmId::rs274_form, fmt::format("Multiple {} words on one line", letter.empty() ? '?' : small(letter[0]))};
    case AlarmId::address_unknown:
    case AlarmId::unexpected_character:
    case AlarmId::control_character:
    case AlarmId::skip_position:
    case AlarmId::block_number_position: return bad_character(report);
    case AlarmId::number_missing: return no_value(report);
    case AlarmId::number_damaged: return number_wrong(report);
    case AlarmId::sign_not_allowed: return {AlarmId::rs274_codes, letter == "M" ? "Negative m code used" : "Negative g code used"};
    case AlarmId::code_unknown: return {AlarmId::rs274_codes, "G-code out of range"};
    case AlarmId::comment_not_closed: return {AlarmId::rs274_form, "Unclosed comment found"};
    case AlarmId::comment_character: return {AlarmId::rs274_form, "Nested comment found"};
    case AlarmId::block_too_long:
    case AlarmId::line_too_long: return {AlarmId::rs274_form, "Command too long"};
    case AlarmId::variable_name_open: return {AlarmId::rs274_parameter, "Named parameter not terminated"};
    case AlarmId::equal_sign_missing: return {AlarmId::rs274_parameter, "Equal sign missing in parameter setting"};
    case AlarmId::variable_unknown: return {AlarmId::rs274_parameter, "Parameter number out of range"};
    case AlarmId::exists_parameter: return {AlarmId::rs274_expression, "Expected # reading parameter"};
    case AlarmId::exists_bracket: return {AlarmId::rs274_expression, "Expected ] reading bracketed parameter"};
    case AlarmId::function_bracket: return {AlarmId::rs274_expression, "Left bracket missing after unary operation name"};
    case AlarmId::function_unknown:
      if (rules.functions.find(there(report)) != nullptr)
        return {AlarmId::rs274_expression, "Left bracket missing after unary operation name"};
      return function_wrong(report);
    case AlarmId::operator_unknown: return operator_wrong(report);
    case AlarmId::bracket_not_closed:
      if (lacks_value(report.line_text)) return {AlarmId::rs274_form, "No characters found in reading real value"};
      return {AlarmId::rs274_expression, "Unclosed expression"};
    case AlarmId::expression_syntax: return expression_wrong(report);
    case AlarmId::division_by_zero:
      if (function_name(there(report)) == "MOD") return {AlarmId::rs274_expression, "Calculation resulted in 'not a number'"};
      return {AlarmId::rs274_expression, "Attempt to divide by zero"};
    case AlarmId::power_of_negative: return {AlarmId::rs274_expression, "Attempt to raise negative to non integer power"};
    case AlarmId::not_a_number: return no_number(report);
    case AlarmId::o_word_unknown: return {AlarmId::rs274_flow, "Unknown control command in o word"};
    case AlarmId::statement_not_alone:
    case AlarmId::o_word_rest: return {AlarmId::rs274_flow, "Unexpected character after O-word"};
    case AlarmId::o_word_arguments: return {AlarmId::rs274_flow, "Too many subroutine parameters"};
    case AlarmId::o_word_bracket:
      if (letter.empty()) return {AlarmId::rs274_flow, "Left bracket missing"};
      return {AlarmId::rs274_flow, fmt::format("Left bracket missing after '{}'", letter)};
    case AlarmId::call_too_deep: return {AlarmId::rs274_flow, "Too many subroutine levels"};
    default: return {no_alarm, {}};
  }
}

bool has_own_text(AlarmId id) { return id >= AlarmId::rs274_form && id <= AlarmId::rs274_abort; }

}  // namespace

tl::unexpected<Alarm> LinuxCnc::fault(AlarmId id, Span where, std::string text) const {
  fault_text_ = std::move(text);
  return fail(alarm(id, where, std::string_view(fault_text_)));
}

void LinuxCnc::reword(const BlockContext& m, AlarmReport& report) const {
  if (has_own_text(report.alarm.id)) {
    if (report.alarm.arg_count == 1 && fault_text_.starts_with(report.alarm.args[0].text())) report.own_text = fault_text_;
    return;
  }
  if (report.alarm.severity != Severity::alarm) return;
  Words words = own_words(report, m.def.grammar.expression);
  if (words.id == no_alarm) return;
  report.alarm.id = words.id;
  report.alarm.arg_count = 1;
  report.alarm.args[0] = AlarmArg(std::string_view(words.text));
  report.own_text = std::move(words.text);
}

}  // namespace kadr::linuxcnc
