#pragma once
// Explains the words of a line on its control: what the page shows under the pointer.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

struct LineWord {
  std::uint32_t from = 0, to = 0;  // columns, counted from 1 in characters: the first character, and the one after the last
  std::string code;                // "G81", "X", "#5021"
  std::string title;               // one line
  std::string text;                // all that kadr explain says; empty: no more than the title
};

/// Explains the words of all blocks of the line, and of a faulty block those read before the fault. Words that the control does not have
/// are left out. A letter is explained by the codes of its own block; a code in force from an earlier block is not known here.
///   line  UTF-8, without its end
std::vector<LineWord> words_of_line(const ControlDef& def, const AlarmTexts& texts, std::string_view line, Lang lang);

}  // namespace kadr
