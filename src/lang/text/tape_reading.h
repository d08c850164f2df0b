#pragma once
// The image of a punched tape → text, whichever way it was put into the reader.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/text/tape_side.h"

namespace kadr {

/// "iso", "eia".
std::optional<TapeCode> tape_code_named(std::string_view name);

struct TapeReading {
  std::string text;               // UTF-8, a line a block; '?' for what cannot be read
  std::vector<TapeFault> faults;  // at most 1000
  TapeCode code = TapeCode::iso;
  TapeLie lie = TapeLie::right;  // another: the rows were turned before they were read
  bool looks_like_tape = false;
};

/// `said`: the code; nothing: as the rows say, ISO where they do not.
TapeReading read_tape(std::string_view rows, std::optional<TapeCode> said);

}  // namespace kadr
