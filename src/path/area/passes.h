#pragma once
// Passes: how a scheme covers a field. How the tool moves from one pass to the next: path/area/layers.

#include "path/area/field.h"

namespace kadr::area {

/// An uninterrupted piece of path.
struct Pass {
  Edges path;
  bool closed = false;  // a ring, which may start anywhere
  bool lifted = false;  // the tool is lifted before it, whatever lies between (Ш)
};
using Passes = std::vector<Pass>;

inline constexpr std::size_t most_passes = 20'000;  // of one layer: beyond it the drawing's unit or the step is wrong

/// Returns the passes of the job's scheme, which together cut everything that the tool can cut.
///   alarms  mill_too_long
Result<Passes> passes_of(const Field& field, const Job& job);

/// Returns equidistant rings (СПИР, АСПИР).
Result<Passes> ring_passes(const Field& field, const Job& job);

/// Returns rows to and fro, or all in one direction; `inset`: mm at which they end before the boundary (0: they follow it).
Result<Passes> row_passes(const Field& field, const Job& job, double inset);

/// Returns passes over what `done` leaves uncut.
Passes rest_passes(const Field& field, const Job& job, const Passes& done);

/// Returns the ring with another start.
Edges begun_at(const Edges& ring, std::size_t edge, double part);

}  // namespace kadr::area
