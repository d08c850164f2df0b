#pragma once
// This file computes the area that the tool cuts along its passes; many passes may overlap.

#include "path/pocketing/mill.h"
#include "path/pocketing/polygon.h"

namespace kadr::area {

/// Computes the same area as swept(), but for many long lines. The areas of neighbouring lines are united in pairs, so that each Clipper
/// operation has only two outlines as its input, even if a hundred passes overlap. The time of a single operation with all lines would grow
/// with the square of their number. If `watch` requests a stop, the function returns the area that is computed up to then. Progress is
/// reported as Stage::verification.
Polygons swept_all(const Polygons& lines, double radius, double chord, const Watch& watch);

}  // namespace kadr::area
