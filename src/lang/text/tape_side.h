#pragma once
// Is it an image of a punched tape, in which code, and does the tape lie as it should?

#include <optional>
#include <string>
#include <string_view>

#include "lang/text/tape.h"

namespace kadr {

/// How a tape was put into the reader.
enum class TapeLie : std::uint8_t {
  right,
  wrong_end,   // its end first: the rows stand in the opposite order
  wrong_side,  // turned over: track 1 is read as track 8
  both,        // turned round: both
};

struct TapeLook {
  TapeCode code = TapeCode::iso;
  TapeLie lie = TapeLie::right;
};

/// 19 of 20 rows have the parity of the code and are codes of program text, at least eight of them and a digit. Where that does not
/// tell how the tape lies, words do: an address stands before its number.
///   returns  nothing: no tape
std::optional<TapeLook> look_at_tape(std::string_view rows);

/// The rows as they are read from the tape put in rightly.
///   law  turned(turned(t, lie), lie) == t
std::string turned(std::string_view rows, TapeLie lie);

/// "wrong_end", … for messages.
std::string_view name_of(TapeLie lie);

}  // namespace kadr
