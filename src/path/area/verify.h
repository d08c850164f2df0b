#pragma once
// Verification: a path, wherever it comes from (a program read back too), against the zones. Distances to walls are those between
// exact lines and arcs, none of the polygons that the path was made with.

#include <optional>

#include "path/area/mill.h"

namespace kadr::area {

struct Outcome {
  double nearest_wall = 0;  // mm, least distance of the tool's centre from a wall below the top; infinite without walls
  double wanted = 0;        // mm: radius and allowance
  double uncut = 0;         // mm² that the tool can reach and leaves, of the worst layer
  double out_of_reach = 0;  // mm² of the zones in corners and places narrower than the tool
  double length = 0;        // mm at feed
  std::optional<Alarm> fault;
};

/// Walls: no nearer than radius + allowance − tol::area_wall. Rapid motion below the top: straight up or down only. Each layer: all that
/// the tool can reach is cut but for cusps lower than tol::area_cusp.
///   alarms  mill_wall, mill_rapid, mill_uncut, in `fault`
Outcome verified(const std::vector<Zone>& zones, const Job& job, const std::vector<Move>& moves);

/// A path that holds, and what was found about it.
struct Verified {
  AreaPath path;
  Outcome outcome;
};

/// The path of the job, verified; where its step leaves something uncut in sharp corners, a smaller one is taken.
///   alarms  those of area_path() and verified()
Result<Verified> verified_path(const std::vector<Zone>& zones, const Job& job);

}  // namespace kadr::area
