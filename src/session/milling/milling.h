#pragma once
// Turns a drawing into a program: contour → path, verified → program → read back by the control itself, verified again
// (docs/commands/mill.md).

#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/contour.h"
#include "config/control_def.h"
#include "out/program/part_program.h"
#include "path/area/verify.h"
#include "session/milling/mill_wish.h"

namespace kadr {

/// What is milled: zones, or lines that the tool follows.
struct MillShape {
  std::vector<area::Zone> zones;
  std::vector<Edges> lines;
};

struct Milled {
  area::Job job;
  MillShape shape;
  area::Verified path;
  PartProgram program;
};

/// Performs all steps. `watch`: for a caller that waits and may interrupt.
///   drawing  DXF, SVG or text, detected by content
///   returns  a fault with its line of the drawing; line 0: it concerns the job as a whole
///   alarms   those of mill_job(), read_contour(), area::chained(), area::zones_of(), area::verified_path(), part_program(), same_moves(),
///            interrupted
tl::expected<Milled, ContourFault> milled(const MillWish& wish, std::string_view drawing, const ControlDef& def,
                                          const area::Watch& watch = {});

}  // namespace kadr
