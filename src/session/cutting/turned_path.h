#pragma once
// Converts the path of a turning tool to a half plane that contains the axis of the rotating part. It is used by session/cutting.
//
// The part rotates about X0 Y0 of its work coordinates. If the tool moves in the plane of X and Z (or of Y and Z), the coordinate in the
// half plane is the signed radius X (or Y). Outside that plane the coordinate is the distance from the axis.

#include <functional>
#include <vector>

#include "session/cutting/tool_path.h"

namespace kadr {

/// Returns the direction, X or Y, that becomes x in the half plane: the one along which the segments are farther from the axis of rotation.
Vec2 radius_axis(const std::vector<PathSegment>& pieces, Vec3 zero);

/// Converts a segment and calls `visit` with one or more straight segments in the half plane: x is the signed radius, y is 0.
///   chord  greatest deviation of the segments from the true distance to the axis, mm
void each_turned(const PathSegment& piece, Vec3 zero, Vec2 axis, double chord, const std::function<void(Vec3 from, Vec3 to)>& visit);

}  // namespace kadr
