#pragma once
// AxisRoles: states which axes of a channel are X, Y, Z, and which axes are rotary.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/vec.h"

namespace kadr {

/// The properties of a channel's axes that the rooms (folders of src) after `control` need.
struct AxisRoles {
  std::size_t count = 3;
  AxisMask rotary = 0;
  std::array<int, 3> xyz{0, 1, 2};  // indices of the axes X, Y, Z; -1: the channel lacks the axis

  static AxisRoles of(const std::vector<std::string>& names, AxisMask rotary) {
    AxisRoles roles{std::min(names.size(), max_axes), rotary, {-1, -1, -1}};
    for (std::size_t i = 0; i < roles.count; ++i)
      if (names[i].size() == 1 && names[i][0] >= 'X' && names[i][0] <= 'Z')
        roles.xyz[static_cast<std::size_t>(names[i][0] - 'X')] = static_cast<int>(i);
    return roles;
  }

  bool is_rotary(std::size_t axis) const { return (rotary >> axis & 1U) != 0; }
};

}  // namespace kadr
