// Converts sections and inserts of a turned part to JSON. Tested by tests/view/turned_part_test.cpp.

#include "view/turned_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace kadr {
namespace {

constexpr double tenths_per_mm = 1e4;  // coordinates are written in steps of 0.1 µm

double in_tenths(double value) { return std::round(value * tenths_per_mm) / tenths_per_mm + 0.0; }

PageJson points_json(const TurnedPolygon& polygon, double from_z) {
  PageJson points = PageJson::array();
  for (const Vec2 p : polygon) points.push_back({in_tenths(p.x), in_tenths(p.y + from_z)});
  return points;
}

}  // namespace

PageJson section_json(const TurnedRegion& section, double zero_z) {
  PageJson polygons = PageJson::array();
  for (const TurnedPolygon& polygon : section) polygons.push_back(points_json(polygon, zero_z));
  return polygons;
}

PageJson turned_json(const PartThen& then, double zero_z) {
  return {{"section", section_json(then.section, zero_z)},
          {"section_y", section_json(then.section_y, zero_z)},
          {"edges", points_json(then.edges, zero_z)}};
}

PageJson inserts_json(const std::vector<ShownInsert>& inserts) {
  PageJson list = PageJson::array();
  for (const ShownInsert& one : inserts) {
    const char* const part = one.part == ToolPart::cutting ? "cutting" : one.part == ToolPart::holder ? "holder" : "shank";
    list.push_back({{"tool", one.tool}, {"part", part}, {"outline", points_json(one.outline, 0)}});
  }
  return list;
}

}  // namespace kadr
