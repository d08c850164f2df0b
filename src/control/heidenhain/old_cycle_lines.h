#pragma once
// The numbers of a line of an old cycle, such as `ABST -2` or `F80 DR+`: its texts are of any language, the digit behind the point says
// what the line means (spec/heidenhain 12.1). Only src/control/heidenhain includes this file.

#include <cstdint>
#include <optional>
#include <string>

namespace kadr::heidenhain {

/// Returns the last number of a line; nullopt if it has none.
std::optional<double> last_number(const std::string& line);

/// Removes the feed, F and its number or Q parameter, from a line and returns it; empty if the line has none.
std::string take_feed(std::string& line);

/// Returns the Q parameter that a line names instead of a number: `DIST Q5`; nullopt if there is none.
std::optional<std::uint16_t> named_parameter(const std::string& line);

}  // namespace kadr::heidenhain
