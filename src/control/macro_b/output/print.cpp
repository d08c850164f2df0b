// Formats the text that DPRNT and BPRNT print, and the variables inside the text of #3107 (nct 23.2.13, 23.1.8). Used by
// control/macro_b/output/output, control/macro_b/output/output_file; tested by tests/control/macro_b/print_test.cpp.

#include "control/macro_b/output/print.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/ascii.h"
#include "lang/text/encoding.h"

namespace kadr::macro_b {
namespace {

constexpr int max_digits = 15;          // greatest number of digits of a printed number: the format [cd] must satisfy 0 < c + d < 16
constexpr int max_binary_decimals = 8;  // greatest number of decimals c in the format [c] of BPRNT
constexpr std::string_view end_of_line = "\r\n";

bool is_blank(char c) { return c == ' ' || c == '\t'; }

Span span(std::size_t begin, std::size_t end) { return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}; }

std::size_t past_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  return at;
}

/// The format after a variable in a print statement: one or two digits in brackets. `[53]` means 5 digits before the decimal point and 3
/// after it.
struct Format {
  int first = 0;
  std::optional<int> second;
  std::size_t size = 0;
};
std::optional<Format> read_format(std::string_view text) {
  if (text.empty() || text[0] != '[') return std::nullopt;
  int digits[2] = {};
  int count = 0;
  std::size_t at = 1;
  for (; at < text.size() && is_digit(text[at]) && count < 2; ++at) digits[count++] = text[at] - '0';
  if (count == 0 || at == text.size() || text[at] != ']') return std::nullopt;
  return Format{digits[0], count == 2 ? std::optional<int>(digits[1]) : std::nullopt, at + 1};
}

/// Returns the print element for the value of a variable; nullopt if the format is not valid for DPRNT or BPRNT (`kind`).
std::optional<PrintPiece> value_piece(const std::optional<Format>& format, PrintKind kind, std::size_t slot) {
  if (!format) return std::nullopt;
  const int second = format->second.value_or(0);
  PrintPiece piece;
  piece.slot = slot;
  if (kind == PrintKind::binary) {
    if (format->second || format->first > max_binary_decimals) return std::nullopt;
    piece.after = static_cast<std::uint8_t>(format->first);
  } else {
    if (format->first + second < 1 || format->first + second > max_digits) return std::nullopt;
    piece.before = static_cast<std::uint8_t>(format->first);
    piece.after = static_cast<std::uint8_t>(second);
  }
  return piece;
}

void add_text(std::vector<PrintPiece>& pieces, std::string_view text) {
  if (pieces.empty() || pieces.back().slot) pieces.emplace_back();
  pieces.back().text += text;
}

/// Returns the end of the bracketed format that starts at `at`, so that an alarm can quote the format. If `]` is missing, returns the end
/// of the text.
std::size_t format_end(std::string_view text, std::size_t at) {
  const std::size_t close = text.find(']', at);
  return close == std::string_view::npos ? text.size() : close + 1;
}

/// Returns the digits of |value| rounded to `after` decimals, ties upwards, without the decimal point; the result has at least after + 1
/// digits. The digits of the exact decimal expansion are rounded, because multiplying by a power of ten would add a rounding error. The
/// first 60 decimals suffice: a double that is not exactly halfway between two numbers of at most 15 decimals differs from the midpoint
/// within 60 decimals.
std::string rounded_digits(double value, int after) {
  constexpr int shown = 60;
  char buffer[std::numeric_limits<double>::max_exponent10 + shown + 8];
  const int size = std::snprintf(buffer, sizeof buffer, "%.*f", shown, std::fabs(value));
  const std::string_view all(buffer, static_cast<std::size_t>(size));
  const std::size_t point = all.size() - shown - 1;
  std::string digits(all.substr(0, point));
  digits += all.substr(point + 1, static_cast<std::size_t>(after));
  if (all[point + 1 + static_cast<std::size_t>(after)] < '5') return digits;
  std::size_t at = digits.size();
  while (at > 0 && digits[at - 1] == '9') digits[--at] = '0';
  if (at == 0) return '1' + digits;
  ++digits[at - 1];
  return digits;
}

double number_of(std::optional<double> value) { return value && std::isfinite(*value) ? *value : 0; }

bool is_zero(std::string_view digits) { return digits.find_first_not_of('0') == std::string_view::npos; }

}  // namespace

Result<PrintText> parse_print(std::string_view text, PrintKind kind, const ReadVariable& read_variable) {
  assert(!text.empty() && text[0] == '[');
  PrintText result;
  std::size_t slots = 0;
  std::size_t at = 1;
  while (at < text.size() && text[at] != ']') {
    const char c = text[at];
    if (c == '#') {
      const Result<std::size_t> variable = read_variable(text.substr(at));
      KADR_TRY(variable);
      const std::size_t open = past_blanks(text, at + *variable);
      const std::optional<Format> format = read_format(text.substr(std::min(open, text.size())));
      const std::optional<PrintPiece> piece = value_piece(format, kind, slots++);
      if (!piece) {
        const std::size_t end = format_end(text, open);
        return fail(alarm(AlarmId::print_format, span(at, end), text.substr(at, end - at)));
      }
      result.pieces.push_back(*piece);
      at = open + format->size;
    } else if (is_letter(c) || is_digit(c) || c == '/' || c == '+' || c == '-' || c == '*') {
      const char sent = c == '*' ? ' ' : to_upper(c);
      add_text(result.pieces, {&sent, 1});
      ++at;
    } else if (is_blank(c)) {
      ++at;
    } else {
      const std::size_t size = std::max<std::size_t>(1, first_character(text.substr(at)).size);
      return fail(alarm(AlarmId::print_format, span(at, at + size), text.substr(at, size)));
    }
  }
  if (at >= text.size()) return fail(alarm(AlarmId::bracket_not_closed, span(0, 1)));
  result.size = at + 1;
  return result;
}

PrintText parse_message(std::string_view text, const ReadVariable& read_variable) {
  PrintText result;
  result.size = text.size();
  std::size_t slots = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at, 2) == "\\n") {
      add_text(result.pieces, "\n");
      at += 2;
      continue;
    }
    if (text[at] == '#') {
      const Result<std::size_t> variable = read_variable(text.substr(at));
      const std::size_t open = variable ? std::min(at + *variable, text.size()) : at;
      const std::optional<Format> format = variable ? read_format(text.substr(open)) : std::nullopt;
      const std::optional<PrintPiece> piece = value_piece(format, PrintKind::decimal, slots);
      if (variable) ++slots;
      if (piece) {
        result.pieces.push_back(*piece);
        at = open + format->size;
        continue;
      }
    }
    add_text(result.pieces, text.substr(at, 1));
    ++at;
  }
  return result;
}

std::string decimal_number(std::optional<double> value, int before, int after, PrintFill fill) {
  const double number = number_of(value);
  const std::string digits = rounded_digits(number, after);
  const std::size_t decimals = static_cast<std::size_t>(after);
  std::string whole = digits.substr(0, digits.size() - decimals);
  if (before == 0 && is_zero(whole)) whole.clear();

  std::string text;
  const bool negative = number < 0 && !is_zero(digits);
  if (negative) text = '-';
  else if (fill == PrintFill::spaces) text = ' ';
  const std::size_t places = static_cast<std::size_t>(before);
  if (fill == PrintFill::spaces && whole.size() < places) text.append(places - whole.size(), ' ');
  text += whole;
  if (after > 0) text += '.' + digits.substr(digits.size() - decimals);
  return text;
}

std::string joined(const std::vector<PrintPiece>& pieces, PrintValues values, PrintFill fill) {
  std::string text;
  for (const PrintPiece& piece : pieces)
    text += piece.slot ? decimal_number(values[*piece.slot], piece.before, piece.after, fill) : piece.text;
  return text;
}

std::string decimal(const std::vector<PrintPiece>& pieces, PrintValues values, PrintFill fill) {
  return joined(pieces, values, fill).append(end_of_line);
}

Result<std::string> binary(const std::vector<PrintPiece>& pieces, PrintValues values) {
  constexpr std::size_t longest = 10;  // number of digits of 2^31, the greatest magnitude of a value that BPRNT prints
  std::string bytes;
  for (const PrintPiece& piece : pieces) {
    if (!piece.slot) {
      bytes += piece.text;
      continue;
    }
    const double value = number_of(values[*piece.slot]);
    std::string digits = rounded_digits(value, piece.after);
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
    const std::int64_t magnitude = digits.size() > longest ? std::numeric_limits<std::int64_t>::max() : std::stoll(digits);
    const std::int64_t number = value < 0 ? -magnitude : magnitude;
    if (number < std::numeric_limits<std::int32_t>::min() || number > std::numeric_limits<std::int32_t>::max())
      return fail(alarm(AlarmId::value_limit, {}, value));
    const auto word = static_cast<std::uint32_t>(static_cast<std::int32_t>(number));
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(word >> shift & 0xFF);
  }
  return bytes.append(end_of_line);
}

}  // namespace kadr::macro_b
