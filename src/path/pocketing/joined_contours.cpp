// This file joins contours that may cross each other: pockets are added, islands subtracted. Used by control/heidenhain.

#include <utility>

#include "base/tolerance.h"
#include "path/pocketing/closed_loops.h"
#include "path/pocketing/exact_path.h"

namespace kadr::area {

std::vector<Zone> zones_between(const std::vector<Edges>& pockets, const std::vector<Edges>& islands) {
  Carriers carriers;
  Polygons area;
  const auto outline_of = [&](const Edges& loop) {
    carriers.add(loop, 0);
    Polygon outline = flattened(loop, tol::area_chord);
    return Polygons{area_of({outline}) < 0 ? flattened(reversed(loop), tol::area_chord) : std::move(outline)};
  };
  for (const Edges& loop : pockets) area = joined(area, outline_of(loop));
  for (const Edges& loop : islands) area = less(area, outline_of(loop));
  std::vector<Zone> zones;
  for (const Polygons& part : parts_of(area)) {
    Zone zone;
    for (const Polygon& loop : part)
      if (Edges exact = carriers.recovered(loop, true); exact.size() > 1) zone.loops.push_back(std::move(exact));
    if (!zone.loops.empty()) zones.push_back(std::move(zone));
  }
  return zones;
}

}  // namespace kadr::area
