#pragma once
// The table of `kadr run --why`: the lines that lose most time, and by what.

#include <string>
#include <vector>

#include "config/alarm_texts.h"
#include "motion/time/lost_time.h"

namespace kadr {

/// A place with the words of the program.
struct LostTimeRow {
  LostTime::Place place;
  std::string file;   // other than the program; else empty
  std::string block;  // text of the line
};

/// `all`: s lost in all lines. Lines ending in '\n'.
std::string lost_time_text(const std::vector<LostTimeRow>& rows, double all, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
