#pragma once
// Links: ways from one pass to the next that stay down.

#include <optional>

#include "path/area/passes.h"

namespace kadr::area {

/// Two arcs from `from` in the direction `out` to `to` in the direction `in`; nothing where they would turn back.
std::optional<Edges> double_arc(Vec2 from, Vec2 out, Vec2 to, Vec2 in);

/// From point to point within the field: straight, or along its boundary if that is not far around.
std::optional<Edges> way_between(const Field& field, Vec2 from, Vec2 to, double detour);

/// How a pass is begun: the way there, and the pass from that start on.
struct Begun {
  Edges way;
  Edges path;
};

/// A pass begun by a tool that stands at `from` and has come in the direction `out`; rings are entered along a double arc where
/// there is room.
std::optional<Begun> begun_from(const Field& field, const Job& job, const Pass& pass, Vec2 from, std::optional<Vec2> out);

/// A ring from the point nearest to `p`.
Edges begun_near(const Edges& ring, Vec2 p);

/// A ring from the middle of its longest edge.
Edges begun_at_longest(const Edges& ring);

/// Quarter of a circle into the beginning of a pass, its radius as large as there is room for.
std::optional<Edge> arc_into(const Field& field, const Job& job, const Edges& path);

/// The same out of its end, to the side where the zone is.
std::optional<Edge> arc_out_of(const Field& field, const Job& job, const Edges& path);

}  // namespace kadr::area
