#pragma once
// OpenStates: a program is converted from one set-up, but runs on a machine whose work offsets, tool lengths, radii and reference points
// differ wherever the set-up does not state them. A conversion must do the same from several such states, not only from zeros.

#include <map>
#include <optional>
#include <vector>

#include "config/control_def.h"
#include "config/setup.h"
#include "convert/program_shape.h"

namespace kadr {

/// A state with values for what a set-up leaves open.
struct OpenState {
  Setup setup;                      // the given set-up of the program's control, and values for what it does not state
  std::map<int, AxisValues> zeros;  // the work offsets among these values, mm, by number of the system
};

/// Returns `count` states in which the program may start, the same ones each time. No two tables share a value; lengths are in tenths of a
/// millimetre, radii in hundredths.
///   axes   names of the program's axes; X, Y and Z get values
///   tools  numbers that the program names
std::vector<OpenState> open_states(const Setup& given, const ControlDef& def, const std::vector<std::string>& axes,
                                   const ProgramNames& names, int count);

}  // namespace kadr
