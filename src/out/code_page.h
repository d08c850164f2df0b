#pragma once
// A control's rows for people: one row (kadr explain), or all of them as the page docs/controls/ID.md.

#include <optional>
#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// What the control's file says of a code (G43, m3), an address (X), a cycle (L81), an alarm (radius_mismatch).
///   returns  nothing, if it has no such row
std::optional<std::string> explain_code(const ControlDef& def, const AlarmTexts& texts, const std::string& what, Lang lang);

/// Overview of a control: its codes in one list.
std::string explain_control(const ControlDef& def, Lang lang);

/// Markdown tables of addresses, codes, cycles, variables.
std::string control_page(const ControlDef& def);

}  // namespace kadr
