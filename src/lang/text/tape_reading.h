#pragma once
// Converts the image of a punched tape to text, whatever the orientation in which the tape was read.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/text/tape_orientation.h"

namespace kadr {

/// Returns the code with this name: "iso", "eia".
std::optional<TapeCode> tape_code_named(std::string_view name);

struct TapeReading {
  std::string text;               // text in UTF-8, one line per block; '?' in place of unreadable rows
  std::vector<TapeFault> faults;  // at most 1000
  TapeCode code = TapeCode::iso;
  // Orientation in which the tape was read; `text` is already that of the correctly inserted tape.
  TapeOrientation orientation = TapeOrientation::right;
  bool looks_like_tape = false;
};

/// Converts the rows to text. `given_code`: the code that the user gives. If it is nullopt, the code is detected from the rows; if the
/// detection fails, the code is ISO.
TapeReading read_tape(std::string_view rows, std::optional<TapeCode> given_code);

}  // namespace kadr
