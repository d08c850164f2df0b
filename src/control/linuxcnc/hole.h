#pragma once
// A hole of a canned cycle, or several (spec/linuxcnc 7.6): what cycles.cpp reads of the words, and hole.cpp makes of it.

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
  std::size_t first = 0, second = 1, drill = 2;  // axes
  double at_first = 0, at_second = 0;
  double step_first = 0, step_second = 0;  // G91, from repetition to repetition
  double level = 0, bottom = 0, clear = 0, present = 0;
  double peck = 0, dwell = 0, i = 0, j = 0, back = 0;
  std::uint32_t repeats = 1;
  bool up_first = false;  // from below R
  bool polar = false;     // G91 with @ ^: each repetition turns on
  double polar_radius = 0, polar_angle = 0;
  AlarmId fault = no_alarm;  // what the control finds at the hole only, when the approach has been made
  bool fault_above = false;  // … when it has risen to R, if it has to
  std::string fault_text;
  Span where;
  SpindleDir spindle = SpindleDir::stop;
  int spindle_number = 0;
  double rpm = 0;
  Plane plane = Plane::xy;
};

/// Begins it: the cycle goes on a few actions at a time.
void begin_drilling(Emitter& m, const Hole& hole);

}  // namespace kadr::linuxcnc
