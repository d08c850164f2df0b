#pragma once
// The data of a canned cycle at one position, or with the word L at several positions (spec/linuxcnc 7.6). cycles.cpp reads the data from
// the words; hole.cpp executes the motions.

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/alarm_ids.h"
#include "base/code_literals.h"
#include "base/span.h"
#include "control/emitter.h"

namespace kadr::linuxcnc {

struct Hole {
  std::int32_t code = 81_g;
  std::size_t first = 0, second = 1, drill = 2;  // indices of the two axes of the plane, and of the drilling axis
  double at_first = 0, at_second = 0;
  double step_first = 0, step_second = 0;  // increments in the plane from one repetition to the next in G91, mm
  double level = 0, bottom = 0, clear = 0, present = 0;
  double peck = 0, dwell = 0, i = 0, j = 0, back = 0;
  std::uint32_t repeats = 1;
  bool up_first = false;  // the tool is below the R level, so the cycle first rises to R
  bool polar = false;     // in G91 with polar words @ ^ each repetition adds polar_radius and polar_angle
  double polar_radius = 0, polar_angle = 0;
  AlarmId fault = no_alarm;  // fault that LinuxCNC detects only when the tool is at the drilling position
  bool fault_above = false;  // true: LinuxCNC detects the fault at the R level, to which the tool may have to rise first
  std::string fault_text;
  Span where;
  SpindleDir spindle = SpindleDir::stop;
  int spindle_number = 0;
  double rpm = 0;
  Plane plane = Plane::xy;
};

/// Starts the canned cycle. The interpreter then executes the cycle a few actions at a time.
void begin_drilling(Emitter& m, const Hole& hole);

}  // namespace kadr::linuxcnc
