#pragma once
// Proposes a change of the program text that follows the hint of an alarm. A change is proposed only if no other change is possible.

#include <optional>
#include <string>

#include "action/action.h"
#include "config/alarm_texts.h"

namespace kadr {

/// A change of the line of the alarm: the characters from column `from` up to, but excluding, column `to` are replaced.
struct QuickFix {
  std::string text;  // sentence that describes the change to the user
  std::uint32_t from = 1, to = 1;
  std::string insert;
};

/// Returns the change.
///   returns  nullopt if no change is certain, or if the text of the line is not available
std::optional<QuickFix> quick_fix(const AlarmReport& report, Lang lang);

}  // namespace kadr
