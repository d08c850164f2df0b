#pragma once
// Box2: a bounding box in a plane.

#include <algorithm>

#include "base/vec.h"

namespace kadr {

struct Box2 {
  Vec2 least;
  Vec2 most;
  void take(Vec2 p) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  }
};

}  // namespace kadr
