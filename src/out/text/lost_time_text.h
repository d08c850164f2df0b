#pragma once
// Writes the table of `kadr run --why`: the lines that lose most time, and the reason.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "motion/time/lost_time.h"

namespace kadr {

/// A location with the text of the program there.
struct LostTimeRow {
  LostTime::Place place;
  std::string file;   // if not the main program, else empty
  std::string block;  // text of the line
};

/// Returns the table, lines ending in '\n'. `all`: s lost in all lines.
std::string lost_time_text(const std::vector<LostTimeRow>& rows, double all, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
