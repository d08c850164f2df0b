// PathModes: finds out which exact stops and corner modes a control has. Used by compare/comparison and convert/conversion; tested by
// tests/compare/comparison_test.cpp.

#include "compare/path_modes.h"

namespace kadr {

PathModes path_modes_of(const ControlDef& def) {
  PathModes modes;
  constexpr int inner_corners = 62;
  for (const CodeRow& row : def.codes) {
    if (!row.works) continue;
    modes.exact = modes.exact || row.function == Function::exact_stop_block || row.function == Function::exact_stop_mode;
    modes.tolerance = modes.tolerance || (row.function == Function::constant_velocity && (row.takes >> ('P' - 'A') & 1U) != 0);
    modes.speeds = modes.speeds || (row.function == Function::feed_control && row.arg == inner_corners);
    modes.smoothing = modes.smoothing || row.function == Function::smoothing;
  }
  return modes;
}

}  // namespace kadr
