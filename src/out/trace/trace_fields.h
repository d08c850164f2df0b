#pragma once
// The fields of a trace line for actions that are no motion (tests/golden/README.md "Actions").

#include <string>

#include "action/action.h"

namespace kadr {

/// What put_number() needs at most.
inline constexpr std::size_t number_room = 32;

std::string number_string(double value);
std::string json_string(std::string_view text);

/// Where the name of an enum's value stands in the table of its names.
template <class E>
constexpr std::size_t row_of(E value) {
  return static_cast<std::size_t>(value);
}

/// `kind","field":value…`: the kind for the head of the line, then the fields; empty: no line.
std::string fields_of(const Action& action);

}  // namespace kadr
