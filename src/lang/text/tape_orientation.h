#pragma once
// Detects whether a file is the image of a punched tape, in which code the tape is, and in which orientation it was read.

#include <optional>
#include <string>
#include <string_view>

#include "lang/text/tape.h"

namespace kadr {

/// The orientation in which a tape was put into the reader.
enum class TapeOrientation : std::uint8_t {
  right,
  wrong_end,   // the tape was read from its end, so the rows are in reverse order
  wrong_side,  // the tape was turned over, so track 1 was read as track 8
  both,        // the tape was read from its end and turned over
};

struct TapeFinding {
  TapeCode code = TapeCode::iso;
  TapeOrientation orientation = TapeOrientation::right;
};

/// Accepts the rows as a tape if 19 of 20 rows have the parity of the code and are codes of program text, with at least eight rows and a
/// digit. If several orientations are possible, the words of the text decide: the address of a word is before its number.
///   returns  nullopt if the rows are not a tape
std::optional<TapeFinding> inspect_tape(std::string_view rows);

/// Returns the rows in the order and with the tracks that the reader would give if the tape were inserted correctly.
///   law  turned(turned(t, lie), lie) == t
std::string turned(std::string_view rows, TapeOrientation orientation);

/// Returns the name of an orientation for messages: "wrong_end", …
std::string_view name_of(TapeOrientation orientation);

}  // namespace kadr
