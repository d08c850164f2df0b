// Makes inserts from offset tables. Tested by tests/session/offset_insert_test.cpp.

#include "session/cutting/offset_insert.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "config/tools/insert_keys.h"
#include "path/compensation/nose_tip.h"

namespace kadr {
namespace {

constexpr double edge_length = 10;                     // mm, as for the turning tools of a LinuxCNC table
constexpr double profiling = 55, profiling_lead = 93;  // degrees: the usual insert and holder for contours
constexpr double narrow = 35;                          // degrees: the narrowest usual nose
constexpr double edges_of_nose = 4;                    // an insert has edges at least this many nose radii long

/// Returns the Fanuc number of a tip.
std::uint8_t tip_of(double position, TipNumbers numbers) {
  constexpr std::array<std::uint8_t, 10> of_linuxcnc{0, 4, 3, 2, 1, 5, 8, 7, 6, 9};
  const auto number = std::uint8_t(std::clamp(position, 0.0, 9.0));
  return numbers == TipNumbers::linuxcnc ? of_linuxcnc[number] : number;
}

}  // namespace

TipNumbers tip_numbers(const ControlDef& def) { return def.dialect == DialectId::linuxcnc ? TipNumbers::linuxcnc : TipNumbers::fanuc; }

bool states_insert(const ControlDef& def, const ToolOffset& row) {
  return def.behaviour.lathe != Lathe::none || (row.tip_position >= 1 && row.tip_position <= 9);
}

std::optional<ToolGeometry> insert_of_offset(const ToolOffset& row, std::uint32_t tool, TipNumbers numbers) {
  const Vec2 tip = nose_vector(tip_of(row.tip_position, numbers), 1);  // Z, X
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
