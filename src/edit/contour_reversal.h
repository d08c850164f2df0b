#pragma once
// ContourReversal: writes the lines of a contour so that the tool runs along it backwards: from its end to its start, arcs the other way
// round, compensation on the other side of the direction, each element with its own feed. The rapid before the contour leads to its other
// end.

#include <tl/expected.hpp>

#include "edit/pattern.h"

namespace kadr {

/// Writes the lines `edits.reverses` backwards.
///   returns  the lines, with the approach before them if it changes; a fault if some line is more than lines, arcs, feeds and compensation
///            in the XY plane, if the contour does not end at the height where it begins, or if compensation does not begin and end in it
tl::expected<Pattern, EditFault> reversed_contour(const EditedSource& program, const Edits& edits, const StopToken& stop);

}  // namespace kadr
