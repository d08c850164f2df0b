#pragma once
// Explains the words of a code, for commands such as `kadr explain nct G81`.

#include <cstdint>
#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the letters of the words that select the tool offset for the code, as a bit set, on controls with such words (NCT, Fanuc: D, H).
std::uint64_t number_words(const ControlDef& def, const CodeRow& row);

/// Returns a line for each letter that the code accepts, e.g. "    R  point R: …, mm".
std::string words_text(const ControlDef& def, const CodeRow& row, Lang lang);

/// Returns the meaning of a letter in a block with that code, e.g. "depth of one peck, positive, mm (inch)".
std::string meaning_of(const ControlDef& def, const CodeRow& code, char letter, Lang lang);

}  // namespace kadr
