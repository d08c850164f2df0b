#pragma once
// Writes the fields of a trace line for actions other than motions (tests/golden/README.md "Actions").

#include <string>

#include "action/action.h"

namespace kadr {

/// Greatest number of characters that put_number() writes.
inline constexpr std::size_t number_room = 32;

std::string number_string(double value);
std::string json_string(std::string_view text);

/// Returns the index of an enum's value in the table of the names of that enum.
template <class E>
constexpr std::size_t row_of(E value) {
  return static_cast<std::size_t>(value);
}

/// Returns `kind","field":value…`: the kind, which completes the beginning of the line, then the fields. The text is empty if the action
/// has no line.
std::string fields_of(const Action& action);

}  // namespace kadr
