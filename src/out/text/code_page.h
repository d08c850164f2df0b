#pragma once
// A control's rows for people: one row (kadr explain), or all of them as the page docs/controls/ID.md.

#include <optional>
#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// What the control's file says of a code (G43, m3), an address (X), a cycle (L81), an alarm by its id or by the control's own
/// number (radius_mismatch, 2012), a system variable (#5021, ABSIO).
///   returns  nothing, if it has no such row
std::optional<std::string> explain_code(const ControlDef& def, const AlarmTexts& texts, const std::string& what, Lang lang);
/// Codes, addresses, cycles and alarms of the control whose text in either language has all these words, a line each; nullopt: none has.
std::optional<std::string> explain_words(const ControlDef& def, const AlarmTexts& texts, const std::string& words, Lang lang);

/// Overview of a control: its codes in one list.
std::string explain_control(const ControlDef& def, Lang lang);

/// Markdown tables of addresses, codes, cycles, variables, alarms (control_page.cpp).
std::string control_page(const ControlDef& def, const AlarmTexts& texts);

/// Cells that both say: "axes I J K"; "*" if in force at power-on; digits of an address as the manual writes them: "+043", "free".
std::string words_of(const CodeRow& row, Lang lang);
std::string initial_mark(const ControlDef& def, const CodeRow& row);
std::string format_of(const ControlDef& def, const AddressRow& row);

}  // namespace kadr
