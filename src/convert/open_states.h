#pragma once
// OpenStates: a program is converted from one set-up, but runs on a machine whose work zeros, tool lengths, radii and reference points are
// others wherever the set-up does not state them. A conversion must do the same from several such states, not from zeros alone.

#include <map>
#include <optional>
#include <vector>

#include "config/control_def.h"
#include "config/setup.h"
#include "convert/program_shape.h"

namespace kadr {

/// What a set-up leaves open, filled in.
struct OpenState {
  Setup setup;                      // of the program's control: the one given, and values for what it does not state
  std::map<int, AxisValues> zeros;  // the work zeros among these values, mm, by number of the system
};

/// `count` states before the start that the set-up allows, the same ones each time: values that no two tables share, in tenths of a
/// millimetre, radii in hundredths.
///   axes   names of the program's axes; X, Y, Z of them get values
///   tools  numbers that the program names
std::vector<OpenState> open_states(const Setup& given, const ControlDef& def, const std::vector<std::string>& axes,
                                   const ProgramNames& names, int count);

}  // namespace kadr
