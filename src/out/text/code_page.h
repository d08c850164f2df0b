#pragma once
// Describes a control's rows for people: one row (kadr explain), or all of them as the page docs/controls/ID.md.

#include <optional>
#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// Returns what the control's file states about a code (G43, m3), an address (X), a canned cycle (L81), an alarm by its id or by the
/// control's own number (radius_mismatch, 2012), or a system variable (#5021, ABSIO).
///   returns  nullopt if the control has no such row
std::optional<std::string> explain_code(const ControlDef& def, const AlarmTexts& texts, const std::string& what, Lang lang);
/// Returns, one per line, the control's codes, addresses, canned cycles and alarms whose text in either language contains all these words;
/// nullopt if there is none.
std::optional<std::string> explain_words(const ControlDef& def, const AlarmTexts& texts, const std::string& words, Lang lang);

/// Returns an overview of the control: its codes in one list.
std::string explain_control(const ControlDef& def, Lang lang);

/// Returns Markdown tables of addresses, codes, canned cycles, variables and alarms (control_page.cpp).
std::string control_page(const ControlDef& def, const AlarmTexts& texts);

/// Cells that both forms show: "axes I J K"; "*" if in force at power-on; digits of an address as the manual writes them: "+043", "free".
std::string words_of(const CodeRow& row, Lang lang);
std::string initial_mark(const ControlDef& def, const CodeRow& row);
std::string format_of(const ControlDef& def, const AddressRow& row);

}  // namespace kadr
