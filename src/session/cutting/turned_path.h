#pragma once
// Converts the path of a turning tool into a half plane that contains the axis of the rotating part. Used by session/cutting.
//
// The part rotates about X0 Y0 of its work system. If the tool moves in the plane of X and Z (or of Y and Z), the coordinate in the half
// plane is the signed radius X (or Y); outside that plane it is the distance from the axis.

#include <functional>
#include <vector>

#include "session/cutting/tool_path.h"

namespace kadr {

/// Returns the direction that is x in the half plane: X or Y, in whichever these pieces go farther from the axis of rotation.
Vec2 radius_axis(const std::vector<PathSegment>& pieces, Vec3 zero);

/// Calls the visitor with one or more straight pieces in the half plane: x is the signed radius, y is 0.
///   chord  mm by which these pieces may deviate from the true distance to the axis
void each_turned(const PathSegment& piece, Vec3 zero, Vec2 axis, double chord, const std::function<void(Vec3 from, Vec3 to)>& visit);

}  // namespace kadr
