#pragma once
// Converts the image of a punched tape to text, in whatever orientation the tape was read.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/text/tape_orientation.h"

namespace kadr {

/// Returns the code with this name: "iso", "eia".
std::optional<TapeCode> tape_code_named(std::string_view name);

struct TapeReading {
  std::string text;               // UTF-8, one line per block; '?' for unreadable rows
  std::vector<TapeFault> faults;  // at most 1000
  TapeCode code = TapeCode::iso;
  TapeOrientation lie = TapeOrientation::right;  // how the tape was read; `text` is the text of the correctly inserted tape
  bool looks_like_tape = false;
};

/// Converts the rows to text. `said`: the code given by the user; nullopt: the code is detected from the rows, and is ISO if that fails.
TapeReading read_tape(std::string_view rows, std::optional<TapeCode> said);

}  // namespace kadr
