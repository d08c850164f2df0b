// Reads the lines of Grbl as words (spec/grbl 1.1 to 1.3). Used by lang/block/lexer; tested by tests/grbl_oracle.py.

#include "lang/block/line_word_reader.h"

#include <cmath>
#include <cstdlib>

#include "base/ascii.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

constexpr double max_block_number = 1e7;  // greatest block number; a word N with a larger number remains a word, which the control checks

/// Returns true for characters that are never part of a line, because the control removes them from the stream and executes them as
/// commands (spec/grbl 12).
bool is_real_time(char c) { return c == '!' || c == '?' || c == '~' || is_high(c); }

}  // namespace

Status LineWordReader::read() {
  filtered_ = filtered(cursor_.text, place_);
  cursor_.at = cursor_.text.size();
  if (grammar_.block_length != 0 && filtered_.size() > grammar_.block_length)
    return fail(alarm(AlarmId::block_too_long, span(0, filtered_.size()), double(filtered_.size()), double(grammar_.block_length)));
  if (filtered_.empty()) return {};
  if (filtered_ == "%") {  // programs that send files to Grbl omit a line with %, so the line has no effect
    block_.warnings.push_back(note(AlarmId::percent_passed_over, span(0, 1)));
    return {};
  }
  if (filtered_[0] != '$') {
    words(0);
    return {};
  }
  Statement& s = block_.statement;
  s.kind = StatementKind::system;
  s.where = s.text = span(0, filtered_.size());
  if (filtered_.starts_with("$J=")) words(3);
  return {};
}

std::string filtered(std::string_view line, std::vector<std::uint32_t>& place) {
  std::string passed;
  bool in_comment = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (in_comment) {
      in_comment = c != ')';
      continue;
    }
    if (c == ';') break;
    in_comment = c == '(';
    if (in_comment || c == '/' || is_real_time(c) || static_cast<unsigned char>(c) <= ' ') continue;
    passed += to_upper(c);
    place.push_back(static_cast<std::uint32_t>(i));
  }
  return passed;
}

std::size_t size_of_number(std::string_view text) {
  std::size_t end = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  bool point = false, digits = false;
  for (; end < text.size() && (is_digit(text[end]) || (text[end] == '.' && !point)); ++end) (text[end] == '.' ? point : digits) = true;
  return digits ? end : 0;
}

void LineWordReader::words(std::size_t from) {
  for (std::size_t at = from; at < filtered_.size();)
    if (!word(at)) return;
}

/// Reads a letter and a number. Returns false if the line has a fault at this word.
bool LineWordReader::word(std::size_t& at) {
  const std::size_t begin = at;
  const char letter = filtered_[at];
  if (!is_capital(letter)) {
    block_.broken = alarm(AlarmId::unexpected_character, span(at, at + 1), std::string_view(filtered_).substr(at, 1));
    return false;
  }
  const std::size_t size = size_of_number(std::string_view(filtered_).substr(++at)), end = at + size;
  if (size == 0) {
    block_.broken = alarm(AlarmId::number_missing, span(begin, at), letter);
    return false;
  }
  const std::string_view number = std::string_view(filtered_).substr(at, end - at);
  at = end;
  if (!grammar_.word(letter).known) {
    block_.broken = alarm(AlarmId::address_unknown, span(begin, end), letter);
    return false;
  }
  if (letter == 'N' && takes_number(number)) {
    block_.number_where = span(begin, end);
    return true;
  }
  if (block_.word_count == limits::block_words) {
    block_.broken = alarm(AlarmId::too_many_words, span(begin, end), double{limits::block_words});
    return false;
  }
  add(letter, number, span(begin, end));
  return true;
}

namespace {

/// The digits of a number that Grbl uses, and the power of ten by which the digits are multiplied.
struct CountedDigits {
  std::uint32_t digits = 0;
  int exponent = 0;
};

CountedDigits counted_digits(std::string_view number) {
  constexpr int max_digits = 8;
  CountedDigits all;
  int count = 0;
  bool fraction = false;
  for (const char c : number) {
    if (c == '.') fraction = true;
    if (!is_digit(c)) continue;
    if (++count > max_digits) all.exponent += fraction ? 0 : 1;
    else all.digits = 10 * all.digits + static_cast<std::uint32_t>(c - '0'), all.exponent -= fraction ? 1 : 0;
  }
  return all;
}

}  // namespace

double value_of_digits(std::string_view number) {
  const auto [digits, exponent] = counted_digits(number);
  if (digits == 0) return 0;
  const double scale = std::pow(10.0, std::abs(exponent)), value = static_cast<double>(digits);
  const double sized = exponent < 0 ? value / scale : value * scale;
  return number[0] == '-' ? -sized : sized;
}

float float32_of_digits(std::string_view number) {
  auto [digits, exponent] = counted_digits(number);
  auto value = static_cast<float>(digits);
  for (; exponent <= -2; exponent += 2) value *= 0.01F;
  if (exponent < 0) value *= 0.1F;
  for (; exponent > 0; --exponent) value *= 10.0F;
  return number[0] == '-' ? -value : value;
}

/// Reads the first N as the block's number, even if the number is not whole. A negative or too large N remains a word.
bool LineWordReader::takes_number(std::string_view number) {
  const double value = value_of_digits(number);
  if (block_.has_number || block_.has('N') || !(value >= 0 && value <= max_block_number)) return false;
  block_.has_number = true;
  block_.number = static_cast<std::uint32_t>(value);
  block_.number_digits = static_cast<std::uint8_t>(std::min<std::size_t>(number.size(), 255));
  return true;
}

void LineWordReader::add(char letter, std::string_view number, Span where) {
  Word& w = block_.words[block_.word_count];
  w = {};
  w.value = value_of_digits(number);
  w.where = where;
  w.address = w.written = letter;
  w.digits = static_cast<std::uint8_t>(std::min<std::size_t>(number.size(), 255));
  w.has_point = number.find('.') != std::string_view::npos;
  if (grammar_.word(letter).code) code_of(w);
  if (!block_.has(letter)) {
    block_.letters |= letter_bit(letter);
    block_.at[static_cast<std::size_t>(letter - 'A')] = static_cast<std::uint8_t>(block_.word_count);
  }
  ++block_.word_count;
}

/// Sets the code to ten times the number, rounded to hundredths before (spec/grbl 1.3: G17.004 is G17). Sets the code to -1 if the number
/// is negative, or has more digits than any code.
void LineWordReader::code_of(Word& w) const {
  constexpr double most = 1e5;
  if (!(w.value >= 0 && w.value < most)) return;
  const auto hundredths = static_cast<std::int32_t>(std::lround(100 * w.value));
  if (hundredths % 10 == 0) w.code = hundredths / 10;
}

Span LineWordReader::span(std::size_t begin, std::size_t end) const {
  const std::uint32_t last = end == 0 ? 0 : place_[end - 1] + 1;
  return {begin < place_.size() ? place_[begin] : last, last};
}

}  // namespace kadr
