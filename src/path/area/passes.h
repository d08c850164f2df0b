#pragma once
// Passes: how a scheme covers a field. Where the tool goes from one to the next: path/area/layers.

#include "path/area/field.h"

namespace kadr::area {

/// A stretch of path without an interruption.
struct Pass {
  Edges path;
  bool closed = false;  // a ring: it may begin anywhere
  bool lifted = false;  // the tool is lifted before it, whatever lies between (Ш)
};
using Passes = std::vector<Pass>;

inline constexpr std::size_t most_passes = 20'000;  // of one layer: beyond it the drawing's unit or the step is wrong

/// The passes of the job's scheme, none left out that the tool can cut.
///   alarms  mill_too_long
Result<Passes> passes_of(const Field& field, const Job& job);

/// Rings at equal distance (СПИР, АСПИР).
Result<Passes> ring_passes(const Field& field, const Job& job);

/// Rows to and fro, or all in one direction; `inset`: mm they end before the boundary (0: they follow it).
Result<Passes> row_passes(const Field& field, const Job& job, double inset);

/// Passes over what is left uncut.
Passes rest_passes(const Field& field, const Job& job, const Passes& done);

/// A ring from another start.
Edges begun_at(const Edges& ring, std::size_t edge, double part);

}  // namespace kadr::area
