#pragma once
// Part program: moves as the text that one control reads, written from its word formats and rows (ControlDef), and read back.

#include <string>
#include <vector>

#include "base/result.h"
#include "config/control_def.h"
#include "path/area/mill.h"

namespace kadr {

/// What a program says beside its moves.
struct Technology {
  double feed = 0;         // mm/min
  double plunge_feed = 0;  // mm/min
  double speed = 0;        // rev/min; 0: the spindle is not named
  std::uint32_t tool = 0;  // 0: no tool is called
  bool coolant = false;
  std::string mark;     // end of block: "ПС", "LF", or empty
  std::string comment;  // in brackets at the beginning; empty: none
};

struct PartProgram {
  std::string text;               // UTF-8
  std::vector<area::Move> moves;  // as written: rounded to the digits of the words
};

/// The program. Arcs that the rounding would bring beyond the control's tolerance, and those shorter than its increments, become lines.
///   alarms  word_has_no_room, function_has_no_code
Result<PartProgram> part_program(const ControlDef& def, const std::vector<area::Move>& moves, const Technology& technology);

/// The two go the same way, point by point.
///   alarms  mill_read_back
Status same_moves(const std::vector<area::Move>& written, const std::vector<area::Move>& read);

}  // namespace kadr
