#pragma once
// Proposes a change of the text that does what the hint of an alarm says, if only one change is possible.

#include <optional>
#include <string>

#include "action/action.h"
#include "config/alarm_texts.h"

namespace kadr {

/// In the alarm's line, replaces the characters from column `from` up to, but not including, `to`.
struct QuickFix {
  std::string text;  // what the change does, for people
  std::uint32_t from = 1, to = 1;
  std::string insert;
};

/// returns  nullopt if no change is certain, or if the line is not known
std::optional<QuickFix> quick_fix(const AlarmReport& report, Lang lang);

}  // namespace kadr
