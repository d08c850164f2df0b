#pragma once
// Verification: checks a path, whatever its source (also a program read back), against the zones. Distances to walls are measured between
// exact lines and arcs, not with the polygons from which the path was computed.

#include <optional>

#include "path/area/mill.h"

namespace kadr::area {

struct Outcome {
  double nearest_wall = 0;  // mm, least distance between the tool's centre and a wall below the top; infinite without walls
  double wanted = 0;        // mm: radius plus allowance
  double uncut = 0;         // mm² of the worst layer that the tool could reach but leaves
  double out_of_reach = 0;  // mm² of the zones in corners and places too narrow for the tool
  double length = 0;        // mm at feed
  std::optional<Alarm> fault;
};

/// Checks the path. Walls: no nearer than radius + allowance − tol::area_wall. Rapid motion below the top: straight up or down only. Each
/// layer: everything that the tool can reach is cut, except cusps lower than tol::area_cusp.
///   alarms  mill_wall, mill_rapid, mill_uncut, in `fault`
Outcome verified(const std::vector<Zone>& zones, const Job& job, const std::vector<Move>& moves);

/// A verified path, and the results of its verification.
struct Verified {
  AreaPath path;
  Outcome outcome;
};

/// Returns the path of the job, verified; if its step leaves material in sharp corners, a smaller step is used.
///   alarms  those of area_path() and verified()
Result<Verified> verified_path(const std::vector<Zone>& zones, const Job& job);

}  // namespace kadr::area
