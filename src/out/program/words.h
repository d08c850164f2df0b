#pragma once
// Formats the words (address and number) of one control according to its word formats.

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include "base/result.h"
#include "config/control/control_def.h"

namespace kadr {

/// Formats the words of one address.
class Words {
 public:
  ///   more  number of additional decimals, if the format allows any number of decimals
  Words(const ControlDef& def, char letter, int more = 0)
      : row_(def.address(letter)),
        format_(def.grammar.word(letter)),
        letter_(letter),
        more_(more),
        counts_(letter == 'F' && !def.grammar.least_increments.empty()),
        decimals_(decimals_of()),
        increment_(row_.scale / ten_to(decimals_)),
        most_(format_.whole_digits > 0 ? ten_to(format_.whole_digits + decimals_) - 1 : max_counts) {}

  char letter() const { return letter_; }
  bool known() const { return format_.known; }
  int decimals() const { return decimals_; }
  double increment() const { return increment_; }
  double rounded(double value) const { return std::round(value / increment_) * increment_; }

  /// Returns the word for a value in the unit of its address: mm, degrees, mm/min, …
  Result<std::string> word(double value) const {
    std::string text;
    if (!append(text, value)) return fail(alarm(AlarmId::word_has_no_room, {}, letter_, value));
    return text;
  }
  /// Like word(), but appends the word to a text. If the value has too many digits for the format, the function returns false and does not
  /// change the text.
  bool append(std::string& text, double value) const {
    const double counts = std::round(value / increment_);
    if (!known() || !(std::abs(counts) <= most_) || (counts < 0 && !format_.sign)) return false;
    const fmt::format_int number(static_cast<std::uint64_t>(std::abs(counts)));
    const std::string_view digits(number.data(), number.size());
    const auto fraction = static_cast<std::size_t>(decimals_);
    text += letter_;
    if (counts < 0) text += '-';
    if (format_.point && !format_.implied) {
      append_with_point(text, digits, fraction);
    } else {
      if (!format_.drop_zeros && digits.size() < format_.whole_digits + fraction)
        text.append(format_.whole_digits + fraction - digits.size(), '0');
      text += digits;
    }
    return true;
  }

 private:
  static constexpr double max_counts = 1e15;
  static double ten_to(int power) {
    constexpr double powers[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    return static_cast<std::size_t>(power) < std::size(powers) ? powers[power] : std::pow(10.0, power);
  }
  static constexpr int free_decimals = 3;  // number of decimals of a word whose format has no limit: 3, for the usual increment of 0.001 mm

  int decimals_of() const {
    if (format_.implied || format_.fraction_digits > 0) return format_.fraction_digits;
    return format_.whole_digits > 0 || (!format_.point && row_.whole) ? 0 : free_decimals + more_;
  }

  /// Appends a length as a number. The decimal point is always written, since without it some controls would count increments.
  void append_with_point(std::string& text, std::string_view digits, std::size_t fraction) const {
    if (digits.size() <= fraction) {
      text += "0.";
      text.append(fraction - digits.size(), '0');
      text += digits;
    } else {
      text += digits.substr(0, digits.size() - fraction);
      text += '.';
      text += digits.substr(digits.size() - fraction);
    }
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.' && row_.unit != WordUnit::length && !counts_) text.pop_back();
  }

  const AddressRow& row_;
  const WordFormat& format_;
  char letter_;
  int more_;
  // True: on this control a number of this address without a decimal point counts increments in some modes (in inches, or with feeds per
  // revolution: spec/haas 1.2, spec/fanuc 1.3).
  bool counts_;
  int decimals_;
  // two values: the increment that the last digit counts, and the greatest number of increments that the format can express
  double increment_, most_;
};

}  // namespace kadr
