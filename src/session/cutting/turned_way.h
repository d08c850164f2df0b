#pragma once
// The way of a turning tool in the half plane that it stands in: what a part that spins sees of it. For session/cutting.
//
// The part spins about X0 Y0 of its work system. A tool whose way lies in the plane of X and Z (or of Y and Z) keeps its signed radius X
// (or Y); beside that plane its distance from the axis counts.

#include <functional>
#include <vector>

#include "session/cutting/tool_way.h"

namespace kadr {

/// Along x of a turning tool, in the plane: X or Y, whichever goes farther from the axis on these pieces.
Vec2 radius_axis(const std::vector<WayPiece>& pieces, Vec3 zero);

/// Visits the piece as one or more straight ones: x the signed radius, y 0.
///   chord  mm by which they may miss the distance from the axis
void each_turned(const WayPiece& piece, Vec3 zero, Vec2 axis, double chord, const std::function<void(Vec3 from, Vec3 to)>& visit);

}  // namespace kadr
