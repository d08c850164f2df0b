#pragma once
// Detects the image of a punched tape, its code, and the orientation in which it was read.

#include <optional>
#include <string>
#include <string_view>

#include "lang/text/tape.h"

namespace kadr {

/// The orientation in which a tape was put into the reader.
enum class TapeLie : std::uint8_t {
  right,
  wrong_end,   // its end first: the rows are in reverse order
  wrong_side,  // turned over: track 1 is read as track 8
  both,        // both
};

struct TapeLook {
  TapeCode code = TapeCode::iso;
  TapeLie lie = TapeLie::right;
};

/// Accepts a tape if 19 of 20 rows have the parity of the code and are codes of program text, with at least eight rows and a digit. If
/// that leaves the orientation open, words decide: an address is before its number.
///   returns  nullopt if it is not a tape
std::optional<TapeLook> look_at_tape(std::string_view rows);

/// Returns the rows as the correctly inserted tape would give them.
///   law  turned(turned(t, lie), lie) == t
std::string turned(std::string_view rows, TapeLie lie);

/// Names for messages: "wrong_end", …
std::string_view name_of(TapeLie lie);

}  // namespace kadr
