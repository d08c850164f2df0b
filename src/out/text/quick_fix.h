#pragma once
// A change of the text that does what the hint of an alarm says, where there is only one.

#include <optional>
#include <string>

#include "action/action.h"
#include "config/alarm_texts.h"

namespace kadr {

/// Of the alarm's line: the characters from column `from` up to before `to` are replaced.
struct QuickFix {
  std::string text;  // what it does, for people
  std::uint32_t from = 1, to = 1;
  std::string insert;
};

/// returns  nothing: no change is certain, or the line is not known
std::optional<QuickFix> quick_fix(const AlarmReport& report, Lang lang);

}  // namespace kadr
