#pragma once
// Links: paths from one pass to the next without lifting the tool.

#include <optional>

#include "path/area/passes.h"

namespace kadr::area {

/// Returns two arcs from `from`, leaving in the direction `out`, to `to`, arriving in the direction `in`; nullopt if they would reverse.
std::optional<Edges> double_arc(Vec2 from, Vec2 out, Vec2 to, Vec2 in);

/// Returns a path within the field between two points: straight, or along the boundary if that is at most `detour` mm longer.
std::optional<Edges> way_between(const Field& field, Vec2 from, Vec2 to, double detour);

/// The start of a pass: the path to it, and the pass from that start on.
struct Begun {
  Edges way;
  Edges path;
};

/// Returns the start of a pass for a tool that is at `from` and arrived in the direction `out`; a ring is entered along a double arc if
/// there is room.
std::optional<Begun> begun_from(const Field& field, const Job& job, const Pass& pass, Vec2 from, std::optional<Vec2> out);

/// Returns the ring starting at the point nearest to `p`.
Edges begun_near(const Edges& ring, Vec2 p);

/// Returns the ring starting in the middle of its longest edge.
Edges begun_at_longest(const Edges& ring);

/// Returns a quarter circle into the start of a pass, with the largest radius that has room.
std::optional<Edge> arc_into(const Field& field, const Job& job, const Edges& path);

/// Likewise, a quarter circle out of the end of a pass, to the side of the zone.
std::optional<Edge> arc_out_of(const Field& field, const Job& job, const Edges& path);

}  // namespace kadr::area
