// Lines of Grbl → words (spec/grbl 1.1 to 1.3). For lang/block/lexer; tested by tests/lang/line_word_test.cpp.

#include "lang/block/line_word_reader.h"

#include <charconv>
#include <cmath>

#include "base/ascii.h"
#include "lang/text/encoding.h"

namespace kadr {
namespace {

constexpr double most_block_number = 1e9;  // a larger one stays a word, which the control judges

/// Characters that a sender's line never holds: the control takes them out of the stream as commands (spec/grbl 12).
bool is_real_time(char c) { return c == '!' || c == '?' || c == '~' || is_high(c); }

}  // namespace

Status LineWordReader::read() {
  filter();
  cursor_.at = cursor_.text.size();
  if (grammar_.block_length != 0 && kept_.size() > grammar_.block_length)
    return fail(alarm(AlarmId::block_too_long, span(0, kept_.size()), double(kept_.size()), double(grammar_.block_length)));
  if (kept_.empty()) return {};
  if (kept_[0] != '$') return words(0), Status();
  Statement& s = block_.statement;
  s.kind = StatementKind::system;
  s.where = s.text = span(0, kept_.size());
  if (kept_.starts_with("$J=")) words(3);
  return {};
}

/// protocol.c: blanks, control characters, `/` and comments are thrown away.
void LineWordReader::filter() {
  bool in_comment = false;
  for (std::size_t i = cursor_.at; i < cursor_.text.size(); ++i) {
    const char c = cursor_.text[i];
    if (in_comment) {
      in_comment = c != ')';
      continue;
    }
    if (c == ';') return;
    in_comment = c == '(';
    if (in_comment || c == '/' || is_real_time(c) || static_cast<unsigned char>(c) <= ' ' || c == '\x7f') continue;
    kept_ += to_upper(c);
    place_.push_back(static_cast<std::uint32_t>(i));
  }
}

void LineWordReader::words(std::size_t from) {
  for (std::size_t at = from; at < kept_.size();)
    if (!word(at)) return;
}

/// A letter and a number; false: the line is broken there.
bool LineWordReader::word(std::size_t& at) {
  const std::size_t begin = at;
  const char letter = kept_[at];
  if (!is_capital(letter)) {
    block_.broken = alarm(AlarmId::unexpected_character, span(at, at + 1), std::string_view(kept_).substr(at, 1));
    return false;
  }
  std::size_t end = ++at;
  if (end < kept_.size() && (kept_[end] == '-' || kept_[end] == '+')) ++end;
  bool point = false, digits = false;
  for (; end < kept_.size() && (is_digit(kept_[end]) || (kept_[end] == '.' && !point)); ++end) (kept_[end] == '.' ? point : digits) = true;
  if (!digits) {
    block_.broken = alarm(AlarmId::number_missing, span(begin, end), letter);
    return false;
  }
  const std::string_view number = std::string_view(kept_).substr(at, end - at);
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

static double value_of_digits(std::string_view number) {
  double value = 0;
  if (number[0] == '+') number.remove_prefix(1);
  (void)std::from_chars(number.data(), number.data() + number.size(), value);
  return value;
}

/// The first N is the block's number, whole or not; one below 0 or too large for a number stays a word.
bool LineWordReader::takes_number(std::string_view number) {
  const double value = value_of_digits(number);
  if (block_.has_number || !(value >= 0 && value < most_block_number)) return false;
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
  if (grammar_.word(letter).code) code_of(w, number);
  if (!block_.has(letter)) {
    block_.letters |= letter_bit(letter);
    block_.at[static_cast<std::size_t>(letter - 'A')] = static_cast<std::uint8_t>(block_.word_count);
  }
  ++block_.word_count;
}

/// Ten times the number; -1 where no code has so many digits, or a sign.
void LineWordReader::code_of(Word& w, std::string_view number) const {
  constexpr double most = 1e6;
  const double tenths = w.value * 10, nearest = std::round(tenths);
  if (number[0] != '-' && nearest < most && std::fabs(tenths - nearest) < 1e-6) w.code = static_cast<std::int32_t>(nearest);
}

Span LineWordReader::span(std::size_t begin, std::size_t end) const {
  const std::uint32_t last = end == 0 ? 0 : place_[end - 1] + 1;
  return {begin < place_.size() ? place_[begin] : last, last};
}

}  // namespace kadr
