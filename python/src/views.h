#pragma once
// Results that need a run of the whole program in a session of its own: its faults, its picture, its axis positions over time.

#include <map>
#include <string>
#include <vector>

#include "program.h"

namespace kadr::python {

/// Returns every fault of the program, each once, in the order in which the run meets them.
///   throws  Interrupted, Failed
std::vector<Finding> check(const ProgramSpec& spec);

/// Returns a picture of the path as SVG or PNG; it ends where an alarm stops the program.
///   kind    ".svg", ".png"
///   throws  Interrupted, Failed
std::string picture(const ProgramSpec& spec, const std::string& kind);

/// The axis positions over time, computed by the planner of least time.
struct AxesInTime {
  std::vector<std::string> axes;
  std::string rows;                       // rows of doubles: the time t, then the position of each axis
  std::map<std::string, double> seconds;  // the parts that the machining time consists of, s
};
///   rate     samples per second; 0: compute the times only
///   longest  time at which the samples end, s
///   throws   Alarmed, Interrupted, Failed
AxesInTime axes_in_time(const ProgramSpec& spec, double rate, double longest);

}  // namespace kadr::python
