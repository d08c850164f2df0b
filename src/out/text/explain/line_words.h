#pragma once
// Explains the words of a program line on its control. The web page shows the text under the mouse pointer.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

struct LineWord {
  // columns, counted in characters from 1: the first character of the word, and the character after its last one
  std::uint32_t from = 0, to = 0;
  std::string code;   // the explained code, address or variable, e.g. "G81", "X", "#5021"
  std::string title;  // one line
  std::string text;   // the whole text that the command `kadr explain` prints; empty: only the title is known
};

/// Explains the words of all blocks of the line. In a faulty block only the words before the fault are explained. Words that the control
/// does not have are omitted. The meaning of a letter comes from the codes in its own block. Codes in force from earlier blocks are not
/// considered.
///   line  the line in UTF-8, without its line break
std::vector<LineWord> words_of_line(const ControlDef& def, const AlarmTexts& texts, std::string_view line, Lang lang);

}  // namespace kadr
