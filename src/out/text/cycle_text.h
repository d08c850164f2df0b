#pragma once
// Describes the steps of a canned cycle in words, from what executes it: the control's steps, its operations (nct 18.1) or its body.

#include <cstdint>
#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// Returns lines "    1. feed to the bottom" under a head; empty if the steps are not known.
std::string steps_text(const ControlDef& def, const CycleRow& row, Lang lang);
/// The same for a code whose canned cycle is built into the engine: G81 of the NCT.
std::string steps_text(const ControlDef& def, const CodeRow& row, Lang lang);
/// Returns the letters (bits) that a drilling code obeys: those of Q, E, P, I, J, K that its own operations use, and every other letter. A
/// code that does not drill obeys all letters.
std::uint64_t words_used(const CodeRow& row);

}  // namespace kadr
