#pragma once
// Describes the table rows of a control for people: one row (kadr explain), or all rows as the page docs/controls/ID.md.

#include <optional>
#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns what the control's file states about a code (G43, m3), an address (X), a canned cycle (L81), an alarm by its id or by the
/// control's own number (radius_mismatch, 2012), or a system variable (#5021, ABSIO).
///   returns  nullopt if the control's file has no row for the text
std::optional<std::string> explain_code(const ControlDef& def, const AlarmTexts& texts, const std::string& what, Lang lang);
/// Returns the control's codes, addresses, canned cycles and alarms whose English or Russian text contains all these words. Each one is on
/// a line of its own. Returns nullopt if no text contains all words.
std::optional<std::string> explain_words(const ControlDef& def, const AlarmTexts& texts, const std::string& words, Lang lang);

/// Returns an overview of the control with a list of its codes.
std::string explain_control(const ControlDef& def, Lang lang);

/// Returns tables of addresses, codes, canned cycles, variables and alarms in Markdown (control_page.cpp).
std::string control_page(const ControlDef& def, const AlarmTexts& texts);

/// Three functions that return the text of a table cell: the words of a code, e.g. "axes I J K"; "*" if the code is in force at power-on;
/// and the format of an address in the notation of the manual, e.g. "+043" or "free".
std::string words_of(const CodeRow& row, Lang lang);
std::string initial_mark(const ControlDef& def, const CodeRow& row);
std::string format_of(const ControlDef& def, const AddressRow& row);

}  // namespace kadr
