#pragma once
// The words of a code with what they mean there: kadr explain nct G81.

#include <cstdint>
#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// Letters of the words that say which offset the code uses, where the control has them as words of their own (NCT, Fanuc: D, H).
std::uint64_t number_words(const ControlDef& def, const CodeRow& row);

/// A line for each letter that the code takes: "    R  point R: …, mm".
std::string words_text(const ControlDef& def, const CodeRow& row, Lang lang);

/// What a letter means beside that code: "depth of one peck, positive, mm (inch)".
std::string meaning_of(const ControlDef& def, const CodeRow& code, char letter, Lang lang);

}  // namespace kadr
