#pragma once
// Proposes a change of the program text that follows the hint of an alarm, if only one change is possible.

#include <optional>
#include <string>

#include "action/action.h"
#include "config/alarm_texts.h"

namespace kadr {

/// In the line of the alarm, replaces the characters from column `from` up to, but not including, column `to`.
struct QuickFix {
  std::string text;  // a sentence that describes the change to the user
  std::uint32_t from = 1, to = 1;
  std::string insert;
};

/// returns  nullopt if no change is certain, or if the text of the line is not available
std::optional<QuickFix> quick_fix(const AlarmReport& report, Lang lang);

}  // namespace kadr
