// Reads the image of a punched tape. Used by cli/tape_command, view/page/page_tape; tested by tests/run_tapes.py, tests/serve_making.py.

#include "lang/text/tape_reading.h"

namespace kadr {

std::optional<TapeCode> tape_code_named(std::string_view name) {
  if (name == "iso") return TapeCode::iso;
  if (name == "eia") return TapeCode::eia;
  return std::nullopt;
}

TapeReading read_tape(std::string_view rows, std::optional<TapeCode> given_code) {
  const std::optional<TapeFinding> seen = inspect_tape(rows);
  TapeReading reading;
  reading.looks_like_tape = seen.has_value();
  reading.code = given_code.value_or(seen ? seen->code : TapeCode::iso);
  reading.orientation = seen ? seen->orientation : TapeOrientation::right;
  TapeText text = decode_tape(reading.orientation != TapeOrientation::right ? turned(rows, reading.orientation) : rows, reading.code);
  reading.text = std::move(text.text);
  reading.faults = std::move(text.faults);
  return reading;
}

}  // namespace kadr
