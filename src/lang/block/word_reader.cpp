// Reads one word with a known address: converts its digits to a value by the format of the address. Used by the rest of lang.

#include "lang/block/word_reader.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/ascii.h"
#include "base/powers_of_ten.h"
#include "lang/block/odd_characters.h"

namespace kadr {
namespace {

// Least and greatest number of digits of a parameter: R01, R123 (spec/correctors 3).
constexpr std::size_t least_parameter_digits = 2, max_parameter_digits = 3;

}  // namespace

Status WordReader::room_for(char letter, const WordFormat& format, std::size_t begin) {
  const std::uint64_t bit = letter_bit(letter);
  if (block_.word_count == limits::block_words)
    return fail(alarm(AlarmId::too_many_words, span(begin, cursor_.at), double{limits::block_words}));
  if ((block_.letters & bit) == 0) [[likely]] {
    block_.letters |= bit;
    block_.at[static_cast<std::size_t>(letter - 'A')] = static_cast<std::uint8_t>(block_.word_count);
    return {};
  }
  if (format.at_most == 0) return {};
  if (format.at_most == 1) return fail(alarm(AlarmId::address_twice, span(begin, cursor_.at), letter));
  std::uint32_t count = 1;
  for (std::uint32_t i = 0; i < block_.word_count; ++i) count += block_.words[i].address == letter;
  if (count <= format.at_most) return {};
  return fail(alarm(AlarmId::too_many_codes, span(begin, cursor_.at), letter, double(count), double(format.at_most)));
}

Status WordReader::value(Word& w, const WordFormat& format, std::size_t begin) {
  char sign = 0;
  const std::size_t sign_at = cursor_.at;
  if (cursor_.peek() == '+' || cursor_.peek() == '-') {
    sign = cursor_.text[cursor_.at++];
    cursor_.skip_blanks();
  }
  if (format.increment && sign == 0 && (cursor_.peek() == 'I' || cursor_.peek() == 'i')) return increment(w, format, begin);
  const char c = cursor_.peek();
  if (grammar_.operator_i && sign == 0 && (c == 'I' || c == 'i') && cursor_.at == begin + 1)
    return fail(alarm(AlarmId::increment_not_allowed, span(begin, cursor_.at + 1), w.address));
  // An argument of a macro may have any sign (nct 23.3); the range of other words is checked later.
  if (is_digit(c) || c == '.') [[likely]] {
    if (sign != 0 && !format.sign && (!grammar_.custom_macros || (sign == '-' && format.code)))
      return fail(alarm(AlarmId::sign_not_allowed, span(sign_at, sign_at + 1), w.address));
    return number(w, format, sign, begin);
  }
  if (format.parameter && parameter_here()) return parameter_sum(w, format, 0, sign == '-' ? '-' : '+', begin);
  if (parameter_here()) return fail(alarm(AlarmId::parameter_not_allowed, span(begin, cursor_.at + 1), w.address));
  if (format.bare && sign == 0 && c != '#' && c != '[') {
    w.bare = true;
    w.value = 0;
    w.digits = 0;
    w.has_point = false;
    return {};
  }
  if (!grammar_.expressions || no_value_follows()) return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), w.address));
  if (grammar_.sums_without_brackets() && c != '#' && c != '[')
    return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), w.address));
  auto expression = grammar_.sums_without_brackets() ? compile_macro_value(cursor_, grammar_, block_, MacroValue::operand)
                                                     : compile_value(cursor_, grammar_, block_);
  if (!expression) return fail(expression.error());
  // The function ROUND in the value of a word rounds to the least increment (spec/haas 2.2).
  if (grammar_.rounds_in_address && format.counted != 0)
    for (std::size_t i = expression->begin; i < expression->end; ++i)
      if (block_.code[i].op == Op::round) block_.code[i].op = Op::round_increment;
  if (sign == '-') {
    block_.code.push_back({grammar_.has_vacant_variables() ? Op::keep_negate : Op::negate, 0, span(sign_at, cursor_.at)});
    ++expression->end;
  }
  block_.evaluates = true;
  block_.codes_vary = block_.codes_vary || format.code;
  w.expression = *expression;
  w.digits = 0;
  w.has_point = false;
  return {};
}

/// Reads XI-40: the operator I, then the number (nct 5.1).
Status WordReader::increment(Word& w, const WordFormat& format, std::size_t begin) {
  ++cursor_.at;
  cursor_.skip_blanks();
  w.incremental = true;
  WordFormat plain = format;
  plain.increment = plain.bare = false;
  return value(w, plain, begin);
}

Status WordReader::number(Word& w, const WordFormat& format, char sign, std::size_t begin) {
  Number read;
  if (!read_number(cursor_, read)) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), w.address));
  if (cursor_.at < cursor_.text.size() && is_blank(cursor_.text[cursor_.at])) {
    if (grammar_.expressions && !grammar_.custom_macros) KADR_TRY(digits_apart(read, w, begin));
    else if (grammar_.word('L').second_number && !read.has_point) KADR_TRY(point_apart(read, w, begin));
  }
  w.digits = static_cast<std::uint8_t>(std::min(read.whole_digits + read.fraction_digits, 255));
  w.has_point = read.has_point;
  if (format.whole_digits != 0) KADR_TRY(check_digits(w, read, format, begin));
  w.value = format.implied && !read.has_point ? read.mantissa / powers_of_ten[format.fraction_digits] : read.value;
  if (format.counted != 0 && !read.has_point) w.value = read.mantissa / powers_of_ten[w.counted = format.counted];
  if (sign == '-') w.value = -w.value;
  if (format.code) KADR_TRY(code_of(w, begin));
  if (format.parameter) {
    const std::size_t end = cursor_.at;
    cursor_.skip_blanks();
    const char c = cursor_.peek();
    // The number before a formal parameter is not scaled, because the value of the parameter is not scaled either.
    const double constant = format.implied ? read.mantissa : read.value;
    if ((c == '+' || c == '-')) return parameter_sum(w, format, sign == '-' ? -constant : constant, c, begin);
    cursor_.at = end;  // blanks after the word are not part of the word
  }
  if (format.second_number) return second_number(w);
  return {};
}

/// Reads a number of RS274/NGC. Blanks in it are ignored, even between digits: `X1 0` is X10.
Status WordReader::digits_apart(Number& read, const Word& w, std::size_t begin) {
  Cursor ahead = cursor_;
  ahead.skip_blanks();
  if (!is_digit(ahead.peek()) && (ahead.peek() != '.' || read.has_point)) return {};
  std::string digits;
  Cursor from{cursor_.text, cursor_.at - read.whole_digits - read.fraction_digits - (read.has_point ? 1u : 0u)};
  while (is_digit(from.peek()) || from.peek() == '.') {
    digits += from.text[from.at++];
    cursor_.at = from.at;
    from.skip_blanks();
  }
  Cursor whole{digits, 0};
  if (!read_number(whole, read) || whole.at != digits.size())
    return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), w.address));
  return {};
}

/// Allows blanks before the decimal point, as in `Y+ 50 .` (spec/correctors 2, N008). Only the notation whose words contain blanks, such as
/// `L2 15`, has such numbers.
Status WordReader::point_apart(Number& read, const Word& w, std::size_t begin) {
  Cursor ahead = cursor_;
  ahead.skip_blanks();
  if (ahead.peek() != '.') return {};
  std::string digits(cursor_.text.substr(cursor_.at - read.whole_digits, read.whole_digits));
  do digits += ahead.text[ahead.at++];
  while (is_digit(ahead.peek()));
  cursor_.at = ahead.at;
  Cursor whole{digits, 0};
  if (!read_number(whole, read)) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), w.address));
  return {};
}

Status WordReader::check_digits(const Word& w, const Number& read, const WordFormat& format, std::size_t begin) const {
  const int most = format.whole_digits + (format.implied && !read.has_point ? format.fraction_digits : 0);
  const Span where = span(begin, cursor_.at);
  if (read.has_point && !format.point) return fail(alarm(AlarmId::point_not_allowed, where, w.address));
  if (read.whole_digits > most) return fail(alarm(AlarmId::too_many_digits, where, w.address, double(read.whole_digits), double(most)));
  if (read.fraction_digits > format.fraction_digits)
    return fail(alarm(AlarmId::too_many_decimals, where, w.address, double(read.fraction_digits), double(format.fraction_digits)));
  if (!format.drop_zeros && !read.has_point && read.whole_digits < most)
    return fail(alarm(AlarmId::too_few_digits, where, w.address, double(read.whole_digits), double(most)));
  return {};
}

Status WordReader::code_of(Word& w, std::size_t begin) const {
  const double tenth = w.value * 10;
  const double nearest = std::round(tenth);
  if (std::fabs(tenth - nearest) > (grammar_.code_by_rounding ? 1e-3 : 1e-9) || nearest < 0 || nearest > 1e9)
    return fail(alarm(AlarmId::code_unknown, span(begin, cursor_.at), cursor_.text.substr(begin, cursor_.at - begin)));
  w.code = static_cast<std::int32_t>(nearest);
  const WordFormat& format = grammar_.word(w.address);
  // spec/gost 3: with the format 3G2 a code has two digits, such as G01; a code with fewer digits gives a warning.
  if (w.digits < format.code_digits && !w.has_point && block_.warnings.size() < limits::block_words)
    block_.warnings.push_back(
        warning(AlarmId::code_digits, span(begin, cursor_.at), cursor_.text.substr(begin, cursor_.at - begin), double(format.code_digits)));
  return {};
}

Status WordReader::second_number(Word& w) {
  const std::size_t end = cursor_.at;
  cursor_.skip_blanks();
  if (!is_digit(cursor_.peek())) {
    cursor_.at = end;  // blanks after the word are not part of the word
    return {};
  }
  Number read;
  if (!read_number(cursor_, read)) return fail(alarm(AlarmId::number_damaged, span(cursor_.at, cursor_.at + 1), w.address));
  w.second = read.value;
  return {};
}

// ---- formal parameters (2С42 6.3.7, spec/correctors 3)

bool WordReader::parameter_here() const {
  const char c = cursor_.peek();
  if (c == '\0') return false;
  return c == grammar_.parameter_address || grammar_.long_parameters.find(c) != std::string::npos;
}

/// Reads the index of the parameter whose letter is at the cursor. Either one digit follows the letter, or two or three digits.
Result<double> WordReader::parameter_index() {
  const std::size_t begin = cursor_.at;
  const char letter = cursor_.text[cursor_.at++];
  std::size_t digits = 0;
  const std::size_t most = letter == grammar_.parameter_address ? 1 : max_parameter_digits;
  double index = 0;
  for (; digits < most && is_digit(cursor_.peek()); ++digits) index = index * 10 + (cursor_.text[cursor_.at++] - '0');
  const std::size_t least = letter == grammar_.parameter_address ? 1 : least_parameter_digits;
  if (digits < least) return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), letter));
  if (letter == grammar_.parameter_address) return index;
  return index + parameters_a_letter * static_cast<double>(grammar_.long_parameters.find(letter));
}

bool WordReader::assigns_parameter(char letter) const {
  if (grammar_.long_parameters.find(letter) == std::string::npos) return false;
  Cursor ahead = cursor_;
  std::size_t digits = 0;
  for (; digits <= max_parameter_digits && is_digit(ahead.peek()); ++digits) ++ahead.at;
  if (digits < least_parameter_digits || digits > max_parameter_digits) return false;
  ahead.skip_blanks();
  return ahead.peek() == '+' || ahead.peek() == '-' || ahead.peek() == '=';
}

Status WordReader::long_parameter(char letter, std::size_t begin) {
  double index = parameters_a_letter * static_cast<double>(grammar_.long_parameters.find(letter));
  double number = 0;
  while (is_digit(cursor_.peek())) number = number * 10 + (cursor_.text[cursor_.at++] - '0');
  index += number;
  cursor_.skip_blanks();
  if (cursor_.peek() == '=') ++cursor_.at, cursor_.skip_blanks();
  const char sign = cursor_.peek();
  if (sign == '+' || sign == '-') ++cursor_.at, cursor_.skip_blanks();
  Number read;
  if ((!is_digit(cursor_.peek()) && cursor_.peek() != '.') || !read_number(cursor_, read))
    return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), letter));
  return assign_parameter(index, sign == '-' ? -read.value : read.value, begin);
}

Status WordReader::parameter_by_sign() {
  const std::size_t begin = cursor_.at++;
  if (assigns_parameter(cursor_.text[begin])) return long_parameter(cursor_.text[begin], begin);
  return fail(unexpected_at(cursor_.text, cursor_.at = begin));
}

Status WordReader::assign_parameter(double index, double value, std::size_t begin) {
  const Span where = span(begin, cursor_.at);
  for (const Assignment& other : block_.assignments)
    if (block_.code[other.target.begin].number == index)
      return fail(alarm(AlarmId::address_twice, where, cursor_.text.substr(begin, cursor_.text.find_first_of("+-= ", begin) - begin)));
  if (block_.assignments.size() == limits::block_assignments)
    return fail(alarm(AlarmId::too_many_words, where, double{limits::block_assignments}));
  const auto target = constant(index, where);
  block_.assignments.push_back({target, constant(value, where), where});
  return {};
}

/// Reads `X+R1`, `Z-1200+R2`. The digits as written and the parameter's value are added; then the sum is converted to the unit of the
/// address.
Status WordReader::parameter_sum(Word& w, const WordFormat& format, double constant, char sign, std::size_t begin) {
  const std::size_t sign_at = cursor_.at;
  if (cursor_.peek() == '+' || cursor_.peek() == '-') {
    ++cursor_.at;
    cursor_.skip_blanks();
  }
  if (!parameter_here()) return fail(alarm(AlarmId::parameter_not_allowed, span(sign_at, cursor_.at + 1), w.address));
  const auto index = parameter_index();
  if (!index) return fail(index.error());
  Expression e;
  e.begin = static_cast<std::uint16_t>(block_.code.size());
  const Span where = span(begin, cursor_.at);
  block_.code.push_back({Op::number, constant, where});
  block_.code.push_back({Op::parameter, *index, where});
  block_.code.push_back({sign == '-' ? Op::subtract : Op::add, 0, where});
  if (format.implied) block_.code.push_back({Op::scale, powers_of_ten[format.fraction_digits], where});
  e.end = static_cast<std::uint16_t>(block_.code.size());
  w.expression = e;
  w.digits = 0;
  return {};
}

/// Reads `R2+50`, which sets R2 to 50. The manual requires the sign (2С42 6.3.7). INFERRED: a number without a sign is positive.
Status WordReader::formal_parameter(std::size_t begin) {
  if (!is_digit(cursor_.peek())) return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), grammar_.parameter_address));
  const double index = cursor_.text[cursor_.at++] - '0';
  cursor_.skip_blanks();
  const char sign = cursor_.peek();
  if (sign == '+' || sign == '-') ++cursor_.at;
  cursor_.skip_blanks();
  Number read;
  if (!is_digit(cursor_.peek()) || !read_number(cursor_, read) || read.has_point)
    return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), grammar_.parameter_address));
  if (read.whole_digits > 7)
    return fail(alarm(AlarmId::too_many_digits, span(begin, cursor_.at), grammar_.parameter_address, double(read.whole_digits), 7.0));
  return assign_parameter(index, sign == '-' ? -read.mantissa : read.mantissa, begin);
}

Expression WordReader::constant(double number, Span where) {
  const auto begin = static_cast<std::uint16_t>(block_.code.size());
  block_.code.push_back({Op::number, number, where});
  return {begin, static_cast<std::uint16_t>(begin + 1)};
}

Status WordReader::block_number(std::size_t begin, const WordFormat& format) {
  Number read;
  if (grammar_.custom_macros && (cursor_.peek() == '#' || cursor_.peek() == '['))
    return fail(alarm(AlarmId::number_by_variable, span(begin, cursor_.at + 1), 'N'));
  if (!is_digit(cursor_.peek()) || !read_number(cursor_, read)) return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), 'N'));
  if (grammar_.code_by_rounding) read.has_point = false, read.value = std::floor(read.value);
  if (block_.has_number) return fail(alarm(AlarmId::address_twice, span(begin, cursor_.at), 'N'));
  if (block_.word_count != 0) return fail(alarm(AlarmId::block_number_position, span(begin, cursor_.at)));
  Word w;
  w.address = 'N';
  if (format.whole_digits != 0) KADR_TRY(check_digits(w, read, format, begin));
  if (read.value >= 1e9 || read.has_point) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), 'N'));
  block_.has_number = true;
  block_.number = static_cast<std::uint32_t>(read.value);
  block_.number_digits = read.whole_digits;
  block_.number_where = span(begin, cursor_.at);
  return {};
}

Status WordReader::label(std::size_t begin, const WordFormat& format) {
  Number read;
  if (!is_digit(cursor_.peek()) || !read_number(cursor_, read))
    return fail(alarm(AlarmId::number_missing, span(begin, cursor_.at), grammar_.label_address));
  if (block_.marker == Marker::label) return fail(alarm(AlarmId::address_twice, span(begin, cursor_.at), grammar_.label_address));
  Word w;
  w.address = grammar_.label_address;
  if (format.whole_digits != 0) KADR_TRY(check_digits(w, read, format, begin));
  if (read.value >= 1e9 || read.has_point) return fail(alarm(AlarmId::number_damaged, span(begin, cursor_.at), grammar_.label_address));
  block_.marker = Marker::label;
  block_.label = static_cast<std::uint32_t>(read.value);
  return {};
}

Status WordReader::axis_by_number(std::size_t begin) {
  cursor_.at += 2;
  cursor_.skip_blanks();
  if (cursor_.peek() != '[') return fail(alarm(AlarmId::expression_syntax, span(begin, cursor_.at + 1), "AX[ ]="));
  const auto axis = compile_macro_value(cursor_, grammar_, block_, MacroValue::operand);
  if (!axis) return fail(axis.error());
  cursor_.skip_blanks();
  if (cursor_.peek() != '=') return fail(alarm(AlarmId::expression_syntax, span(begin, cursor_.at + 1), "AX[ ]="));
  ++cursor_.at;
  cursor_.skip_blanks();
  if (block_.word_count == limits::block_words)
    return fail(alarm(AlarmId::too_many_words, span(begin, cursor_.at), double{limits::block_words}));
  Word& w = block_.words[block_.word_count];
  w.address = w.written = indirect_axis;
  w.code = -1;
  w.incremental = w.bare = false;
  w.expression = {};
  w.axis = *axis;
  w.value = 0;
  if (cursor_.peek() == 'I' || cursor_.peek() == 'i') {
    w.incremental = true;
    ++cursor_.at;
  }
  // INFERRED: a whole expression may follow the `=`.
  const auto expression = compile_macro_value(cursor_, grammar_, block_, MacroValue::sum);
  if (!expression) return fail(expression.error());
  w.expression = *expression;
  block_.evaluates = true;
  w.where = span(begin, cursor_.at);
  ++block_.word_count;
  return {};
}

const AddressName* WordReader::name_here() const {
  const AddressName* best = nullptr;
  for (const AddressName& row : grammar_.names) {
    if (cursor_.text.size() - cursor_.at < row.text.size() || (best != nullptr && best->text.size() >= row.text.size())) continue;
    std::size_t i = 0;
    while (i < row.text.size() && to_upper(cursor_.text[cursor_.at + i]) == row.text[i]) ++i;
    if (i < row.text.size()) continue;
    Cursor after{cursor_.text, cursor_.at + i};
    after.skip_blanks();
    if (is_digit(row.text.back()) && after.peek() != '=') continue;
    best = &row;
  }
  return best;
}

bool WordReader::marks_end(std::string_view mark, std::size_t at) const {
  if (grammar_.end_of_block == EndOfBlock::line_only || !cursor_.text.substr(at).starts_with(mark)) return false;
  const std::size_t next = at + mark.size();
  return next >= cursor_.text.size() || is_blank(cursor_.text[next]) || cursor_.text[next] == '(';
}

bool WordReader::no_value_follows() const {
  if (cursor_.at >= cursor_.text.size()) return true;
  const char c = cursor_.text[cursor_.at];
  if (c == '(' || c == ';' || c == '/') return true;
  return is_high(c) || marks_end("LF", cursor_.at);
}

}  // namespace kadr
