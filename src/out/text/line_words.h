#pragma once
// The words of a line with what each means on its control: what the page shows under the pointer.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

struct LineWord {
  std::uint32_t from = 0, to = 0;  // columns, counted from 1 in characters: its first, and that behind its last
  std::string code;                // "G81", "X", "#5021"
  std::string title;               // in a line
  std::string text;                // all that kadr explain says of it; empty: there is no more than the title
};

/// Of all blocks that stand in the line; of a faulty block what was read before the fault. Words that the control has not are left out.
/// A letter means what the codes of its block make of it; what a code in force from an earlier block makes of it is not known here.
///   line  UTF-8, without its end
std::vector<LineWord> words_of_line(const ControlDef& def, const AlarmTexts& texts, std::string_view line, Lang lang);

}  // namespace kadr
