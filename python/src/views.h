#pragma once
// What is made of a whole program, by a way through it of its own: its faults, its picture, its axes in time.

#include <map>
#include <string>
#include <vector>

#include "program.h"

namespace kadr::python {

/// Every fault that the program has, each once, in the order in which they are met.
///   throws  Interrupted, Failed
std::vector<Finding> check(const ProgramSpec& spec);

/// The path as SVG or PNG, up to where an alarm stops it.
///   kind    ".svg", ".png"
///   throws  Interrupted, Failed
std::string picture(const ProgramSpec& spec, const std::string& kind);

/// The axes in time by the planner of least time.
struct AxesInTime {
  std::vector<std::string> axes;
  std::string rows;                       // of doubles: t, then each axis
  std::map<std::string, double> seconds;  // what the time is made of
};
///   rate     Hz; 0: the times only
///   longest  s
///   throws   Alarmed, Interrupted, Failed
AxesInTime axes_in_time(const ProgramSpec& spec, double rate, double longest);

}  // namespace kadr::python
