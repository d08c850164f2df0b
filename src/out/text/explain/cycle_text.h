#pragma once
// Describes the steps of a canned cycle in words. The data are those that the engine executes: the control's step list, its operations (nct
// 18.1) or the blocks of the cycle's macro.

#include <cstdint>
#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns a heading and below it one line for each step, e.g. "    1. feed to the bottom"; empty if the steps are unknown.
std::string steps_text(const ControlDef& def, const CycleRow& row, Lang lang);
/// Returns a heading and the steps, in the same form, for a code whose canned cycle the engine itself contains, e.g. G81 of the NCT.
std::string steps_text(const ControlDef& def, const CodeRow& row, Lang lang);
/// Returns the address letters that a drilling code uses, as a bit set. Of the letters Q, E, P, I, J, K only those are included that the
/// operations of the code need. A code that does not drill uses all letters.
std::uint64_t words_used(const CodeRow& row);

}  // namespace kadr
