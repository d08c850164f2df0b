#pragma once
// drive_hand: the operator at a stop of the program: jogging, probing, setting offsets, changing the tool; and how the program continues.

#include "cli/drive_program.h"
#include "cli/drive_run.h"

namespace kadr::cli {

/// Reads the controller's offsets and position again. Returns false after a fault, which is printed.
bool read_offsets(drive::GrblDriver& driver);

/// Lets the operator work by hand until he lets the program continue. Returns false if he ends it, or after a fault.
bool work_by_hand(drive::GrblDriver& driver);

/// Where and how a program continues, or begins in its middle.
struct Continuation {
  std::uint32_t line = 1;
  bool by_hand = false;                                   // the operator has moved the machine: the lines are shown, and Kadr asks
  bool keeps_offsets = true;                              // false: the controller was reset before
  std::optional<drive::GrblPoint> place;                  // where the tool was when the job was left
  std::optional<drive::GrblSettings> offsets_at_place{};  // and the offsets then, if they may be changed by hand
  double clear = 0, spin_up = 0;
};

/// Reads the controller's offsets again, and opens the rest of the program. Prints what will be sent before the line, and asks if the
/// operator has moved the machine. Returns nullptr if it cannot continue, or shall not.
std::unique_ptr<drive::GrblJob> continued(drive::GrblDriver& driver, const DriveProgram& program, const Continuation& how);

/// Lets the controller read the program in its check mode ($C), in which nothing moves. Prints what it refuses, and returns false.
bool check_mode(drive::GrblDriver& driver, drive::GrblJob& job);

/// Asks whether to move. The conversation with the controller goes on meanwhile.
bool hears_go(drive::GrblDriver& driver);

}  // namespace kadr::cli
