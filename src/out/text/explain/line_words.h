#pragma once
// Explains the words of a program line on its control: the text that the web page shows under the mouse pointer.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

struct LineWord {
  std::uint32_t from = 0, to = 0;  // columns in characters, from 1: the first character of the word, and the one after its last
  std::string code;                // "G81", "X", "#5021"
  std::string title;               // one line
  std::string text;                // the whole text of kadr explain; empty: there is only the title
};

/// Explains the words of all blocks of the line; of a faulty block only the words before the fault. Words that the control does not have
/// are left out. A letter is explained by the codes of its own block; codes in force from earlier blocks are not considered.
///   line  UTF-8, without its line break
std::vector<LineWord> words_of_line(const ControlDef& def, const AlarmTexts& texts, std::string_view line, Lang lang);

}  // namespace kadr
