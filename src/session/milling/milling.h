#pragma once
// Converts a drawing to a program: contour → path, which is verified → program, which the control reads back and which is verified again
// (docs/commands/mill.md).

#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/control/control_def.h"
#include "config/drawing/drawing.h"
#include "out/program/part_program.h"
#include "path/pocketing/verify.h"
#include "session/milling/mill_request.h"

namespace kadr {

/// What is to be milled: areas, or lines that the tool follows.
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

/// Performs all steps. `watch`: shows the progress to the caller, which may interrupt the work.
///   drawing  text of the drawing: DXF, SVG or plain text, detected by content
///   returns  a fault with its line of the drawing; line 0: the fault concerns the job as a whole
///   alarms   those of mill_job(), read_drawing(), area::chained(), area::zones_of(), area::verified_path(), part_program(), same_moves(),
///            interrupted
tl::expected<Milled, DrawingFault> milled(const MillRequest& request, std::string_view drawing, const ControlDef& def,
                                          const area::Watch& watch = {});

}  // namespace kadr
