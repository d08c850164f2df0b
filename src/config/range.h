#pragma once
// Permitted ranges of numbers in files: one range for each quantity, the same for set-ups, machine files and control files. A range
// prevents a typing error (a minus sign, 1e-300, NaN) from becoming a motion that never ends. The limits are far beyond any machine.

#include <optional>
#include <string>

#include "texts/ranges.h"

namespace kadr {

struct NumberRange {
  double least, most;
  std::optional<PlainText> unit = std::nullopt;
};

namespace ranges {
inline constexpr NumberRange position = {-1e7, 1e7, texts::ranges::mm_or_degrees};  // range of positions: up to 10 km, as in programs
inline constexpr NumberRange distance = {0, 1e7, texts::ranges::mm};
inline constexpr NumberRange diameter = {1e-6, 1e7, texts::ranges::mm};
// Range of rapid rates: a rate must not be zero, since its motion would never end
inline constexpr NumberRange rate = {1e-3, 1e9, texts::ranges::rate};
inline constexpr NumberRange feed = {0, 1e9, texts::ranges::feed};
inline constexpr NumberRange acceleration = {1e-3, 1e9, texts::ranges::acceleration};
inline constexpr NumberRange jerk = {1e-3, 1e12, texts::ranges::jerk};
inline constexpr NumberRange seconds = {0, 86400, texts::ranges::seconds};  // range of times: up to a day
inline constexpr NumberRange speed = {0, 1e6, texts::ranges::speed};
// Greatest permitted change of a direction (KinematicsSetup::singular)
inline constexpr NumberRange singular = {0, 5, texts::ranges::degrees};
inline constexpr NumberRange percent = {0, 1000, texts::ranges::percent};
inline constexpr NumberRange scale = {1e-9, 1e9};
inline constexpr NumberRange any = {-1e300, 1e300};
}  // namespace ranges

/// Returns true if the value is a number (not NaN) within the range.
constexpr bool is_within(double value, const NumberRange& range) { return value >= range.least && value <= range.most; }

/// Returns the permitted numbers in words, such as "a number, 0 to 86400 s", in the language of messages.
std::string range_in_words(const NumberRange& range);

}  // namespace kadr
