#pragma once
// Describes the steps of a canned cycle in words. The steps come from the data that the engine executes: the control's step list, its
// operations (nct 18.1) or the cycle's macro body.

#include <cstdint>
#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns lines "    1. feed to the bottom" below a heading; empty if the steps are not known.
std::string steps_text(const ControlDef& def, const CycleRow& row, Lang lang);
/// Like the function above, for a code whose canned cycle is built into the engine: G81 of the NCT.
std::string steps_text(const ControlDef& def, const CodeRow& row, Lang lang);
/// Returns the address letters (as bits) that a drilling code uses: those of Q, E, P, I, J, K that its operations need, and every other
/// letter. A code that does not drill uses all letters.
std::uint64_t words_used(const CodeRow& row);

}  // namespace kadr
