#pragma once
// drive_run: sends a job to a connected controller, with the operator at the keyboard; and what the operator reads.

#include <optional>
#include <string>

#include "drive/grbl/grbl_driver.h"

namespace kadr::cli {

/// Returns a position as text: "X1.000 Y2.000 Z0.000".
std::string point_text(const drive::GrblPoint& point);

/// How long kadr drive waits for bytes while the operator may press a key, and otherwise; and for the end of a stop, s.
struct DriveTimes {
  static constexpr double key = 0.004, step = 0.02, stop = 12;
};

/// How a job ended.
struct JobEnd {
  int status = 0;
  std::optional<std::uint32_t> continues_at;  // the line at which the program continues: after a probe motion, or a stop
  bool by_hand = false;                       // the operator moves the machine before: after a tool change, or because he wants to
};

/// Sends the job, and executes what the operator types: h hold, r resume, s stop, m by hand at a stop, + and - the feed.
///   lines  number of lines of the job, for the progress
///   feed   feed override at the beginning, %
JobEnd run_job(drive::GrblDriver& driver, drive::GrblJob& job, std::uint64_t lines, int feed);

/// Sends a line such as `$H` and waits for its answer. Prints an error and returns false if the controller refuses it.
bool run_command(drive::GrblDriver& driver, const std::string& text, double patience);

}  // namespace kadr::cli
