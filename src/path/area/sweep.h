#pragma once
// Sweep: what the tool cuts along a path, however closely its passes lie.

#include "path/area/mill.h"
#include "path/area/polygon.h"

namespace kadr::area {

/// As swept(), for many and long lines: neighbours are joined two by two, so that of a hundred passes that lie over each other Clipper
/// never sees more than the outlines of two (all at once takes the square of their number). When asked to stop it returns what it has; it
/// tells how far it is as a part of the verification.
Polygons swept_all(const Polygons& lines, double radius, double chord, const Watch& watch);

}  // namespace kadr::area
