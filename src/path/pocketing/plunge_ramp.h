#pragma once
// Ramps: finds a sloped path along which the tool goes down into uncut material near the start of a pass.

#include <optional>

#include "path/pocketing/field.h"

namespace kadr::area {

/// Extent of the smallest ramp, in tool radii. INFERRED: the teeth at the end of the tool leave a core of about a tenth of its diameter. A
/// movement by twice the size of the core removes the core (a bore of 1.2 tool diameters, the least that tool makers allow for a helix).
inline constexpr double ramp_core = 0.4;

/// The plan view of a ramp: a path from the start of a pass, followed back and forth or in circles while the tool goes down. It ends
/// where it starts.
struct Ramp {
  Polygon corners;
  bool round = false;
  int times = 0;     // number of revolutions if `round`, else of strokes (even)
  double along = 0;  // total horizontal length, mm
};

/// Returns the first of these ramps for which there is enough clearance: along the pass, a helix, a straight line, along the boundary of
/// the field. If none of them has it, returns the ramp with the greatest extent; nullopt if even this extent is less than ramp_core,
/// because the tool would then drill.
///   drop  depth to go down, mm
///   law   drop <= along · tan(job.ramp_deg); the whole ramp lies in the field
std::optional<Ramp> ramp_for(const Field& field, const Job& job, const Edges& path, double drop);

}  // namespace kadr::area
