#pragma once
// Part program: converts a list of moves to the text of a program for one control, with the control's word formats and code table
// (ControlDef). Also checks that the control executes the same moves from the text.

#include <string>
#include <vector>

#include "base/result.h"
#include "config/control/control_def.h"
#include "path/pocketing/mill.h"

namespace kadr {

/// The data of a program in addition to its moves: feeds, spindle speed, tool, comment.
struct Technology {
  double feed = 0;         // mm/min
  double plunge_feed = 0;  // mm/min
  double speed = 0;        // spindle speed, rev/min; 0: the program contains no speed
  std::uint32_t tool = 0;  // tool number; 0: the program contains no tool change
  bool coolant = false;
  std::string mark;     // mark at the end of each block: "ПС", "LF" or empty
  std::string comment;  // comment at the beginning of the program, written in brackets; empty: no comment
};

struct PartProgram {
  std::string text;  // UTF-8
  // the moves of the tool with the coordinates that the text states, which are rounded to the decimals of the words
  std::vector<area::Move> moves;
};

/// Creates the program. An arc becomes a line if rounded words would exceed the control's arc tolerance, or if the arc is too short for the
/// least increment.
///   alarms  word_has_no_room, function_has_no_code
Result<PartProgram> part_program(const ControlDef& def, const std::vector<area::Move>& moves, const Technology& technology);

/// Creates a program without a move: it begins and ends as the control requires, with the plane, absolute coordinates, millimetres and feed
/// per minute as far as the control has codes for them.
///   alarms  word_has_no_room, function_has_no_code
Result<std::string> bare_program(const ControlDef& def);

/// Checks that the moves `read`, which the control executes, follow the same path as the moves `written`, from which the program was
/// created. They are compared point by point.
///   alarms  mill_read_back
Status same_moves(const std::vector<area::Move>& written, const std::vector<area::Move>& read);

}  // namespace kadr
