#pragma once
// The steps of a cycle in words, from what carries it out: the control's steps, its operations (nct 18.1) or its body.

#include <cstdint>
#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// Lines "    1. feed to the bottom" under a head; empty, if nothing is known.
std::string steps_text(const ControlDef& def, const CycleRow& row, Lang lang);
/// The same of a code whose cycle is of the engine's: G81 of the NCT.
std::string steps_text(const ControlDef& def, const CodeRow& row, Lang lang);
/// Letters (bits) that a drilling code obeys: of Q, E, P, I, J, K those that its own operations use; all of any other code.
std::uint64_t words_used(const CodeRow& row);

}  // namespace kadr
