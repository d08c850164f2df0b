#pragma once
// Part program: writes a list of moves as text for one control, by its word formats and code table (ControlDef), and checks that the
// text, read back, gives the same moves.

#include <string>
#include <vector>

#include "base/result.h"
#include "config/control/control_def.h"
#include "path/pocketing/mill.h"

namespace kadr {

/// The data of a program besides its moves: feeds, speed, tool, comment.
struct Technology {
  double feed = 0;         // mm/min
  double plunge_feed = 0;  // mm/min
  double speed = 0;        // rev/min; 0: no speed is written
  std::uint32_t tool = 0;  // tool number; 0: no tool change is written
  bool coolant = false;
  std::string mark;     // end-of-block mark of the text: "ПС", "LF" or empty
  std::string comment;  // comment at the beginning, written in brackets; empty: no comment
};

struct PartProgram {
  std::string text;               // UTF-8
  std::vector<area::Move> moves;  // the moves with the coordinates as written, that is, rounded to the digits of the words
};

/// Writes the program. An arc becomes a line if rounding its words would exceed the control's arc tolerance, or if it is too short for
/// the least increment.
///   alarms  word_has_no_room, function_has_no_code
Result<PartProgram> part_program(const ControlDef& def, const std::vector<area::Move>& moves, const Technology& technology);

/// Checks that both lists of moves follow the same path, point by point.
///   alarms  mill_read_back
Status same_moves(const std::vector<area::Move>& written, const std::vector<area::Move>& read);

}  // namespace kadr
