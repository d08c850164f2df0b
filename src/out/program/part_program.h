#pragma once
// Part program: writes moves as the text that one control reads, from its word formats and rows (ControlDef), and compares moves read back.

#include <string>
#include <vector>

#include "base/result.h"
#include "config/control_def.h"
#include "path/area/mill.h"

namespace kadr {

/// What a program states besides its moves.
struct Technology {
  double feed = 0;         // mm/min
  double plunge_feed = 0;  // mm/min
  double speed = 0;        // rev/min; 0: no speed is written
  std::uint32_t tool = 0;  // 0: no tool is called
  bool coolant = false;
  std::string mark;     // end of block: "ПС", "LF" or empty
  std::string comment;  // written in brackets at the beginning; empty: none
};

struct PartProgram {
  std::string text;               // UTF-8
  std::vector<area::Move> moves;  // as written, that is, rounded to the digits of the words
};

/// Writes the program. An arc that the rounding would bring out of the control's tolerance, or that is too short for its increments,
/// becomes a line.
///   alarms  word_has_no_room, function_has_no_code
Result<PartProgram> part_program(const ControlDef& def, const std::vector<area::Move>& moves, const Technology& technology);

/// Checks that both follow the same path, point by point.
///   alarms  mill_read_back
Status same_moves(const std::vector<area::Move>& written, const std::vector<area::Move>& read);

}  // namespace kadr
