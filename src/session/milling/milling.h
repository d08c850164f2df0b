#pragma once
// Converts a drawing to a program in three steps (docs/commands/mill.md): the contour is converted to a path, which is verified. The path
// is converted to a program. The control executes the program, and the resulting path is verified again.

#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "config/control/control_def.h"
#include "config/drawing/drawing.h"
#include "out/program/part_program.h"
#include "path/pocketing/verify.h"
#include "session/milling/mill_request.h"

namespace kadr {

/// The shape that is milled: either areas, or lines that the tool follows.
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

/// Converts a drawing to a verified program. `watch`: shows the progress to the caller, who may interrupt the work.
///   drawing  text of the drawing: DXF, SVG or plain text, which is recognised by its content
///   returns  a fault with its line of the drawing; line 0: the fault concerns the job as a whole
///   alarms   mill_lathe; those of mill_job(), read_drawing(), area::chained(), area::zones_of(), area::verified_path(), part_program(), same_moves(),
///            and interrupted
tl::expected<Milled, DrawingFault> milled(const MillRequest& request, std::string_view drawing, const ControlDef& def,
                                          const area::Watch& watch = {});

}  // namespace kadr
