#pragma once
// This file finds a sloped path along which the tool moves down into uncut material near the start of a pass.

#include <optional>

#include "path/pocketing/field.h"

namespace kadr::area {

/// Extent of the smallest ramp, in tool radii. INFERRED: the teeth at the end of the tool leave a core of about a tenth of its diameter. A
/// movement by twice the size of the core removes the core. Such a helix makes a bore of 1.2 tool diameters, the smallest bore that tool
/// makers allow.
inline constexpr double ramp_core = 0.4;

/// The plan view of a ramp: a path from the start of a pass. The tool follows this path back and forth or in circles while it moves down.
/// The ramp ends where it starts.
struct Ramp {
  Polygon corners;
  bool round = false;
  int times = 0;     // number of revolutions if `round` is true; otherwise the number of strokes, which is even
  double along = 0;  // total horizontal length of all strokes or revolutions, mm
};

/// Returns the first ramp that has enough clearance. The order of the attempts is: along the pass, a helix, a straight line, along the
/// boundary of the field. If no ramp has enough clearance, the function returns the ramp with the greatest extent. It returns nullopt if
/// even this extent is less than ramp_core, because the tool would then drill.
///   drop  depth by which the tool moves down, mm
///   law   drop <= along · tan(job.ramp_deg); the whole ramp lies in the field
std::optional<Ramp> ramp_for(const Field& field, const Job& job, const Edges& path, double drop);

}  // namespace kadr::area
