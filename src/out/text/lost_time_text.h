#pragma once
// Writes the table of `kadr run --why`: the program lines that lose most time, and the reason for each.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "motion/time/lost_time.h"

namespace kadr {

/// A program line that loses time, with its text.
struct LostTimeRow {
  LostTime::Place place;
  std::string file;   // name of the called file; empty for the main program
  std::string block;  // the text of the program line
};

/// Returns the table, lines ending in '\n'. `all` is the time lost in all lines together, s.
std::string lost_time_text(const std::vector<LostTimeRow>& rows, double all, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
