#pragma once
// Converts the path of a turning tool into the half plane of the tool, as a rotating part meets it. Used by session/cutting.
//
// The part rotates about X0 Y0 of its work system. A tool whose path is in the plane of X and Z (or of Y and Z) keeps its signed radius X
// (or Y); outside that plane its distance from the axis counts.

#include <functional>
#include <vector>

#include "session/cutting/tool_way.h"

namespace kadr {

/// The direction that counts as x of a turning tool: X or Y, whichever goes farther from the axis on these pieces.
Vec2 radius_axis(const std::vector<WayPiece>& pieces, Vec3 zero);

/// Visits the piece as one or more straight ones: x is the signed radius, y is 0.
///   chord  mm by which they may deviate from the distance to the axis
void each_turned(const WayPiece& piece, Vec3 zero, Vec2 axis, double chord, const std::function<void(Vec3 from, Vec3 to)>& visit);

}  // namespace kadr
