#pragma once
// drive_run: sends a job to a connected controller, with the operator at the keyboard; and what the operator reads.

#include <string>

#include "drive/grbl/grbl_driver.h"

namespace kadr::cli {

/// Returns a position as text: "X1.000 Y2.000 Z0.000".
std::string point_text(const drive::GrblPoint& point);
/// Returns the sentence about a fault, in the language of the thread.
///   seconds  time of motion that the controller may still execute
std::string fault_text(const drive::LinkEvent& event, double seconds);

/// Sends the job, and executes what the operator types: h hold, r resume, s stop.
///   lines    number of lines of the job, for the progress
///   returns  the exit status
int run_job(drive::GrblDriver& driver, drive::GrblJob& job, std::uint64_t lines);

/// Sends a line such as `$H` and waits for its answer. Prints an error and returns false if the controller refuses it.
bool run_command(drive::GrblDriver& driver, const std::string& text, double patience);

}  // namespace kadr::cli
