#pragma once
// Ramps: how a tool goes down at a slope into uncut material, near the start of a pass.

#include <optional>

#include "path/area/field.h"

namespace kadr::area {

/// Extent of the smallest ramp, in tool radii. INFERRED: end teeth leave a core of about a tenth of the diameter; moving by twice the
/// core removes it (a bore of 1.2 diameters, the least that tool makers allow for a helix).
inline constexpr double ramp_core = 0.4;

/// A level path from the start of a pass, followed to and fro or round and round while the tool goes down; it ends where it starts.
struct Ramp {
  Polygon corners;
  bool round = false;
  int times = 0;     // turns, or strokes (an even number)
  double along = 0;  // total length, mm
};

/// Returns the first of these that has room: along the pass, a helix, a straight line, along the boundary of the field; if all are
/// narrow, the widest one. nullopt if the tool could move less than ramp_core of its radius: there it would drill.
///   drop  mm to go down
///   law   drop <= along · tan(job.ramp_deg); the whole ramp lies in the field
std::optional<Ramp> ramp_for(const Field& field, const Job& job, const Edges& path, double drop);

}  // namespace kadr::area
