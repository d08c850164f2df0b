#pragma once
// Verification: checks a tool path against the zones. The path may come from any source, for example from a program that was read back.
// Distances to walls are measured between exact lines and arcs, not with the polygons from which the path was computed.

#include <optional>

#include "path/pocketing/mill.h"

namespace kadr::area {

struct Outcome {
  // least distance between the tool's centre and a wall while the tool is below the top, mm; infinite without walls
  double nearest_wall = 0;
  double wanted = 0;        // required distance between the tool's centre and a wall: radius plus allowance, mm
  double uncut = 0;         // area that the tool could reach but leaves uncut, in the worst layer, mm²
  double out_of_reach = 0;  // area of the zones in corners and narrow parts that the tool cannot reach, mm²
  double length = 0;        // length of all moves at feed, mm
  std::optional<Alarm> fault;
};

/// Checks the path. Walls: the tool's centre comes no nearer than radius + allowance − tol::area_wall. Rapid motion below the top:
/// straight up or down only. Each layer: everything that the tool can reach is cut, except cusps lower than tol::area_cusp.
///   alarms  mill_wall, mill_rapid, mill_uncut, in `fault`
Outcome verified(const std::vector<Zone>& zones, const Job& job, const std::vector<Move>& moves);

/// A verified path, and the results of its verification.
struct Verified {
  AreaPath path;
  Outcome outcome;
};

/// Computes and verifies the path of the job. If the job's step leaves material in sharp corners, a smaller step is used.
///   alarms  those of area_path() and verified()
Result<Verified> verified_path(const std::vector<Zone>& zones, const Job& job);

}  // namespace kadr::area
