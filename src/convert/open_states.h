#pragma once
// OpenStates: further set-ups for the proof of a conversion. A program is converted with one set-up, but may run on machines with other
// values for the work offsets, tool lengths, radii and reference points that this set-up does not state. The converted program must do the
// same from several such states, not only if these values are 0.

#include <map>
#include <optional>
#include <vector>

#include "config/control/control_def.h"
#include "config/setup/setup.h"
#include "convert/program_shape.h"

namespace kadr {

/// A set-up with values for the table rows that the given set-up does not state.
struct OpenState {
  Setup setup;                      // the given set-up of the source control, with added values for the rows that it does not state
  std::map<int, AxisValues> zeros;  // the work offsets that were added, mm, by number of the work system
};

/// Returns `count` states in which the program may start. Each call returns the same states. No two table rows have the same value; lengths
/// are multiples of 0.1 mm, radii of 0.01 mm.
///   def, to  source control and target control; if one of them is that of a lathe, tools also get lengths along X and numbers of tips
///   axes   axis names of the program; X, Y and Z get values
///   tools  tool numbers that the program contains
std::vector<OpenState> open_states(const Setup& given, const ControlDef& def, const ControlDef& to, const std::vector<std::string>& axes,
                                   const ProgramNames& names, int count);

}  // namespace kadr
