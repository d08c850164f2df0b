#pragma once
// This file computes the passes by which a scheme (zigzag, rings, comb) covers a field. path/pocketing/layers computes how the tool moves
// from one pass to the next pass.

#include "path/pocketing/field.h"

namespace kadr::area {

/// A section of the tool's path that is cut without interruption.
struct Pass {
  Edges path;
  bool closed = false;  // true for a ring, which may start at any of its points
  bool lifted = false;  // True if the tool is always lifted before this pass, even if a direct path exists (comb schemes, Ш).
};
using Passes = std::vector<Pass>;

// The greatest number of passes of one layer. A greater number means that the unit of the drawing or the step is wrong.
inline constexpr std::size_t max_passes = 20'000;

/// Returns the passes of the job's scheme. Together they cut everything that the tool can cut.
///   alarms  mill_too_long
Result<Passes> passes_of(const Field& field, const Job& job);

/// Returns the passes of the schemes СПИР and АСПИР, which are equidistant rings.
Result<Passes> ring_passes(const Field& field, const Job& job);

/// Returns parallel rows, cut back and forth or all in the same direction. `inset` is the distance, mm, between the ends of the rows and
/// the boundary. If `inset` is 0, the rows are connected along the boundary.
Result<Passes> row_passes(const Field& field, const Job& job, double inset);

/// Returns passes that cut the areas that the passes `done` leave uncut.
Passes rest_passes(const Field& field, const Job& job, const Passes& done);

/// Returns the ring with its start moved to the fraction `part` of the edge with the index `edge`.
Edges begun_at(const Edges& ring, std::size_t edge, double part);

}  // namespace kadr::area
