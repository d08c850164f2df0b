#pragma once
// Formats the table of `kadr run --why`: the program lines that lose the most time, with the reason for each.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "motion/time/lost_time.h"

namespace kadr {

/// A program line that loses time, and its text.
struct LostTimeRow {
  LostTime::Place place;
  std::string file;   // name of the called file that contains the line; empty: the main program
  std::string block;  // text of the program line
};

/// Returns the table with the lines that lose the most time. Each row ends in '\n'. `all`: the time that all lines of the program together
/// lose, s.
std::string lost_time_text(const std::vector<LostTimeRow>& rows, double all, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
