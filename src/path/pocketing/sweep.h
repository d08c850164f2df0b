#pragma once
// Sweep: computes the area that the tool cuts along its passes, also for many overlapping passes.

#include "path/pocketing/mill.h"
#include "path/pocketing/polygon.h"

namespace kadr::area {

/// Like swept(), for many long lines. The areas of neighbouring lines are united in pairs, so that each Clipper operation has only two
/// outlines as its input, even if a hundred passes overlap (the time of one operation with all lines grows with the square of their
/// number). If `watch` requests a stop, returns the area computed so far. Progress is reported as Stage::verification.
Polygons swept_all(const Polygons& lines, double radius, double chord, const Watch& watch);

}  // namespace kadr::area
