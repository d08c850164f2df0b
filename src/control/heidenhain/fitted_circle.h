#pragma once
// The circle through measured points. Only src/control/heidenhain includes this file.

#include <optional>
#include <vector>

#include "base/vec.h"

namespace kadr::heidenhain {

struct FittedCircle {
  Vec2 centre;
  double radius = 0;
};

/// Returns the circle that fits three or more points best; three points lie on it. Returns nullopt for points on a line.
std::optional<FittedCircle> fitted_circle(const std::vector<Vec2>& points);

}  // namespace kadr::heidenhain
