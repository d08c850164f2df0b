#pragma once
// Describes punched tape in words. Used by kadr tape and the web page.

#include <string>
#include <string_view>

#include "config/alarm_texts.h"
#include "lang/text/tape_orientation.h"

namespace kadr {

/// Returns how the tape is oriented: "read from its wrong end: turned".
std::string orientation_in_words(TapeOrientation lie, Lang lang);

/// Returns "row 241: parity error (byte 100)"; the byte is octal.
std::string fault_in_words(const TapeFault& fault, TapeCode code, Lang lang);

/// Returns "ISO-7" or "EIA".
std::string_view name_for_people(TapeCode code);

}  // namespace kadr
