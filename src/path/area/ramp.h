#pragma once
// Ramps: how a tool goes down at a slope into material that is not yet cut, near the start of a pass.

#include <optional>

#include "path/area/field.h"

namespace kadr::area {

/// Of the tool's radius: the extent of the smallest ramp. INFERRED: end teeth leave a core of a tenth of the diameter or so; moved by two
/// of these it is gone (a bore of 1.2 diameters, the least that makers of tools allow a helix).
inline constexpr double ramp_core = 0.4;

/// A level way from the start of a pass, gone to and fro or round and round while the tool goes down; it ends where it begins.
struct Ramp {
  Polygon corners;
  bool round = false;
  int times = 0;     // turns, or strokes (an even number)
  double along = 0;  // mm of all of them
};

/// The first of these that has room: along the pass, a helix, a straight line, along the boundary of the field; then the largest of them.
/// None where the tool could move less than ramp_core of its radius: there it would drill.
///   drop  mm to go down
///   law   drop <= along · tan(job.ramp_deg); every point of it lies in the field
std::optional<Ramp> ramp_for(const Field& field, const Job& job, const Edges& path, double drop);

}  // namespace kadr::area
