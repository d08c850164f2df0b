#pragma once
// Sweep: the area that the tool cuts along its passes, however closely they lie.

#include "path/area/mill.h"
#include "path/area/polygon.h"

namespace kadr::area {

/// Like swept(), for many and long lines: neighbours are joined pairwise, so that Clipper never sees more than the outlines of two of a
/// hundred overlapping passes (the time for all at once grows with the square of their number). When asked to stop, it returns what it
/// has; it reports its progress as part of the verification.
Polygons swept_all(const Polygons& lines, double radius, double chord, const Watch& watch);

}  // namespace kadr::area
