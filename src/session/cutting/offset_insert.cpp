// Makes inserts from offset tables. Tested by tests/session/turned_cutting_test.cpp.

#include "session/cutting/offset_insert.h"

#include <algorithm>
#include <cmath>

#include "config/tools/insert_keys.h"
#include "path/compensation/nose_tip.h"

namespace kadr {
namespace {

constexpr double edge_length = 10;                     // mm, as for the turning tools of a LinuxCNC table
constexpr double profiling = 55, profiling_lead = 93;  // degrees: the usual insert and holder for contours
constexpr double narrow = 35;                          // degrees: the narrowest usual nose
constexpr double edges_of_nose = 4;                    // an insert has edges at least this many nose radii long

}  // namespace

std::optional<ToolGeometry> insert_of_offset(const ToolOffset& row, std::uint32_t tool) {
  const auto number = std::uint8_t(std::clamp(row.tip_position, 0.0, 9.0));
  const Vec2 tip = nose_vector(number, 1);  // Z, X
  const double radius = std::max(row.whole_radius(), 0.0);
  const bool at_centre = tip == Vec2{};
  if (at_centre && !(radius > 0)) return std::nullopt;
  ToolGeometry g;
  g.number = tool;
  g.kind = ToolKind::turning;
  g.corner = radius;
  g.insert.tip_z = int(std::lround(tip.x)), g.insert.tip_x = int(std::lround(tip.y));
  if (!at_centre) {
    const bool corner = g.insert.tip_x != 0 && g.insert.tip_z != 0;
    g.angle = corner ? profiling : narrow;
    if (corner) g.insert.lead = profiling_lead;
    g.flutes = std::max(edge_length, edges_of_nose * radius);
  }
  complete_insert(g);
  g.length = g.flutes;
  return g;
}

}  // namespace kadr
