#pragma once
// DncProfile: how a control without a network exchanges programs over a serial line: line, code, ends of blocks, handshake.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "drive/port/byte_port.h"
#include "lang/text/tape.h"

namespace kadr::drive {

/// What makes the sender begin, wait and go on.
enum class DncHandshake : std::uint8_t {
  none,      // nothing: the control is fast enough, or RTS and CTS do it
  xon_xoff,  // the control sends DC3 to stop the sender and DC1 to let it go on; the sender begins at once
  dc_codes,  // as xon_xoff, and the sender begins only after DC1 (Fanuc reader/punch)
};

/// How the program is coded on the line.
enum class DncCode : std::uint8_t {
  ascii,     // bytes as they are
  iso_even,  // ISO 7-bit code with even parity in the eighth bit, as on punched tape
  eia,       // EIA RS-244 with odd parity, as on punched tape
};

struct DncProfile {
  const char* id;
  LineSettings line;
  DncCode code;
  DncHandshake handshake;
  std::string_view end_of_block;  // bytes at the end of each line (ascii only)
  std::size_t leader;             // NUL bytes before and after the program
  bool percent;                   // the program begins and ends with a line `%`
  const char* source;             // manual
};

std::span<const DncProfile> dnc_profiles();
const DncProfile* dnc_profile_named(std::string_view id);

/// Returns the bytes of a program on the line.
///   text    UTF-8, lines separated by LF
///   alarms  bad_encoding  a character that the code does not have; where: its place in the text
Result<std::string> dnc_bytes(const DncProfile& profile, std::string_view text);

/// A program that was received.
struct DncText {
  std::string text;             // UTF-8, lines separated by LF
  std::size_t faults = 0;       // bytes with wrong parity, or without meaning in the code
  std::size_t first_fault = 0;  // the number of the first of them, from 1
};
DncText dnc_text(const DncProfile& profile, std::string_view bytes);

}  // namespace kadr::drive
