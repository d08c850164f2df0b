#pragma once
// Describes a punched tape in words. This file is used by kadr tape and the web page.

#include <string>
#include <string_view>

#include "config/alarm_texts.h"
#include "lang/text/tape_orientation.h"

namespace kadr {

/// Returns the orientation of the tape in words, e.g. "read from its wrong end: turned".
std::string orientation_in_words(TapeOrientation orientation, Lang lang);

/// Returns the fault in words, e.g. "row 241: parity error (byte 100)". The byte is an octal number.
std::string fault_in_words(const TapeFault& fault, TapeCode code, Lang lang);

/// Returns the name of the tape code: "ISO-7" or "EIA".
std::string_view name_for_people(TapeCode code);

}  // namespace kadr
