#pragma once
// This file checks a tool path against the zones. The path may come from any source, for example from a program that was read back.
// Distances to walls are measured between exact lines and arcs, not with the polygons from which the path was computed.

#include <optional>

#include "path/pocketing/mill.h"

namespace kadr::area {

struct Outcome {
  // The least distance, mm, between the tool's centre and a wall while the tool is below the level `top`. The value is infinite if the
  // zones have no walls.
  double nearest_wall = 0;
  double required = 0;      // required distance, mm, between the tool's centre and a wall: tool radius plus allowance
  double uncut = 0;         // Area, mm², that the tool could reach but leaves uncut, in the layer with the largest such area.
  double out_of_reach = 0;  // Area, mm², of the corners and narrow parts of the zones that the tool cannot reach.
  double length = 0;        // total length of all moves at feed, mm
  std::optional<Alarm> fault;
};

/// Checks the path against three rules. The distance of the tool's centre from walls is at least radius + allowance − tol::area_wall. Below
/// the top, rapid motion is straight up or down only. In each layer the tool cuts everything that it can reach, except cusps lower than
/// tol::area_cusp.
///   alarms  mill_wall, mill_rapid, mill_uncut, in `fault`
Outcome verified(const std::vector<Zone>& zones, const Job& job, const std::vector<Move>& moves);

/// A verified path with the results of its verification.
struct Verified {
  AreaPath path;
  Outcome outcome;
};

/// Computes and verifies the path of the job. If the job's step leaves material in sharp corners, the function uses a smaller step.
///   alarms  those of area_path() and verified()
Result<Verified> verified_path(const std::vector<Zone>& zones, const Job& job);

}  // namespace kadr::area
