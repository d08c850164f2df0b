// Writes changed numbers of words. Used by edit/program_editor; tested by tests/edit.py.

#include "edit/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ascii.h"

namespace kadr {
namespace {

// The greatest number of decimals that a format without limit gets. Nothing in a shop is set finer than this.
constexpr int free_decimals = 5;

std::string_view number_in(std::string_view text) {
  const std::size_t begin = text.find_first_of("+-.0123456789");
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

std::string with_zeros(std::string digits, std::size_t count) {
  return digits.size() < count ? std::string(count - digits.size(), '0') + digits : digits;
}

/// Returns the digits of a number that counts the last of `decimals` decimals; nullopt if there are more digits than `most`.
std::optional<std::string> counts(double value, int decimals, std::size_t most) {
  std::string digits = fmt::format("{:.0f}", std::round(std::abs(value) * std::pow(10.0, decimals)));
  return digits.size() <= most ? std::optional(digits) : std::nullopt;
}

}  // namespace

std::optional<std::string> word_with_value(std::string_view text, const Word& word, const ControlDef& def, double value) {
  const WordFormat& format = def.grammar.word(word.address);
  const std::string_view old = number_in(text);
  const std::string head(text.substr(0, text.size() - old.size()));
  const bool has_point = old.find('.') != std::string_view::npos;
  const std::string_view old_digits = old.substr(std::min(old.find_first_not_of("+-"), old.size()));
  if (value < 0 && !format.sign) return std::nullopt;
  const char* const plus = old.starts_with('+') ? "+" : "";
  constexpr std::size_t any = 18;
  const bool limited = format.whole_digits > 0;
  if (!has_point && (format.implied || word.counted > 0)) {
    const int decimals = word.counted > 0 ? word.counted : format.fraction_digits;
    auto digits = counts(value, decimals, limited ? std::size_t(format.whole_digits) + format.fraction_digits : any);
    if (!digits) return std::nullopt;
    const bool is_padded = !format.drop_zeros || old_digits.starts_with('0');
    return head + (value < 0 ? "-" : plus) + (is_padded ? with_zeros(*digits, old_digits.size()) : *digits);
  }
  // A length without a point may count increments, depending on a parameter (spec/fanuc 1.3), and 0 does not show whether it does
  const bool needs_point = has_point || (format.point && word.value == 0 && def.address(word.address).unit == WordUnit::length);
  const int most = !format.point && !format.implied ? 0 : limited || format.fraction_digits > 0 ? format.fraction_digits : free_decimals;
  std::string number = fmt::format("{:.{}f}", std::abs(value), most);
  if (number.find('.') != std::string::npos) {
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.' && !needs_point) number.pop_back();
  } else if (needs_point) {
    number += '.';
  }
  const std::size_t whole = std::min(number.find('.'), number.size());
  if (limited && whole > format.whole_digits) return std::nullopt;
  if (!has_point && old_digits.size() > 1 && old_digits.starts_with('0') && whole == number.size())
    number = with_zeros(number, old_digits.size());
  return head + (value < 0 && number.find_first_not_of("0.") != std::string::npos ? "-" : plus) + number;
}

std::string word_with_operation(std::string_view text, std::string_view operation) {
  std::size_t begin = 0;
  while (begin < text.size() && is_letter(text[begin])) ++begin;
  return fmt::format("{}[{}{}]", text.substr(0, begin), text.substr(begin), operation);
}

}  // namespace kadr
