#pragma once
// This file computes paths from one pass to the next pass without lifting the tool.

#include <optional>

#include "path/pocketing/milling_passes.h"

namespace kadr::area {

/// Returns two tangent arcs from `from` to `to`. The path leaves `from` in the direction `out` and arrives at `to` in the direction `in`.
/// Returns nullopt if the arcs would reverse the direction of travel.
std::optional<Edges> double_arc(Vec2 from, Vec2 out, Vec2 to, Vec2 in);

/// Returns a path between two points within the field: a straight line, or a path along the boundary that is at most `detour` mm longer
/// than the straight line; nullopt if neither is possible.
std::optional<Edges> link_between(const Field& field, Vec2 from, Vec2 to, double detour);

/// A pass with a chosen start. `link` is the path to the start; `path` is the pass from this start.
struct PassStart {
  Edges link;
  Edges path;
};

/// Returns the start of a pass and the path to this start from `from`. The tool has arrived at `from` in the direction `out`. A closed pass
/// (ring) is entered along a double arc if there is clearance for the arcs.
std::optional<PassStart> pass_start_from(const Field& field, const Job& job, const Pass& pass, Vec2 from, std::optional<Vec2> out);

/// Returns the ring with its start moved to the point nearest to `p`.
Edges begun_near(const Edges& ring, Vec2 p);

/// Returns the ring with its start moved to the middle of its longest edge.
Edges begun_at_longest(const Edges& ring);

/// Returns a quarter circle that leads tangentially into the start of a pass, with the largest radius for which there is clearance.
std::optional<Edge> arc_into(const Field& field, const Job& job, const Edges& path);

/// Returns a quarter circle that leads tangentially out of the end of a pass, away from the wall, with the largest radius for which there
/// is clearance.
std::optional<Edge> arc_out_of(const Field& field, const Job& job, const Edges& path);

}  // namespace kadr::area
