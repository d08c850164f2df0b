// This file computes the passes by which a scheme covers a field. Used by the other folders of path.

#include "path/pocketing/milling_passes.h"

#include <algorithm>

#include "base/tolerance.h"

namespace kadr::area {
namespace {

/// Returns the distance, mm, between the ends of the rows and the boundary, for schemes in which a separate pass follows the boundary.
double inset_of(const Job& job) { return std::max(0.0, std::min(0.1 * job.radius, 2 * job.radius - job.step)); }

Passes contour_passes(const Field& field) {
  Passes passes;
  for (const Edges& loop : field.work) passes.push_back({loop, true});
  return passes;
}

/// Returns the two corners of the area that have the greatest distance from each other. If the area has many corners, only some of them are
/// compared.
Polygon long_axis(const Polygon& area) {
  Polygon axis{area[0], area[0]};
  const std::size_t stride = 1 + area.size() / 200;
  for (std::size_t i = 0; i < area.size(); i += stride)
    for (std::size_t j = 0; j < i; j += stride)
      if (length(area[i] - area[j]) > length(axis[1] - axis[0])) axis = {area[i], area[j]};
  return axis;
}

Edges along(const Polygon& corners, const Carriers& carriers) { return carriers.recovered(corners, false); }

}  // namespace

Edges begun_at(const Edges& ring, std::size_t edge, double part) {
  Edges path;
  const Edge& first = ring[edge];
  if (part < 1) path.push_back(section(first, part, 1));
  for (std::size_t i = 1; i < ring.size(); ++i) path.push_back(ring[(edge + i) % ring.size()]);
  if (part > 0) path.push_back(section(first, 0, part));
  std::erase_if(path, [](const Edge& e) { return length(e.to - e.from) < tol::same_point; });
  return path;
}

/// Returns passes that cut the remaining areas. A remaining area inside the work area is cut by a line along its longest extent. A
/// remaining area at a wall, which the tool's centre cannot enter, is cut from the nearest points on the boundary of `reach`; at an open
/// side `reach` extends beyond the work area.
Passes rest_passes(const Field& field, const Job& job, const Passes& done) {
  Polygons paths, rims;
  for (const Pass& pass : done) paths.push_back(flattened(pass.path, tol::area_chord));
  Carriers carriers;
  for (const Edges& loop : field.reach) {
    carriers.add(loop, 0);
    rims.push_back(flattened(loop, tol::area_chord));
    rims.back().push_back(rims.back().front());
  }
  Passes passes;
  for (const Polygons& part : parts_of(uncut(field, job, paths))) {
    const Polygons inside = common({part[0]}, field.work_area);
    for (const Polygon& piece : inside) {
      const Edges axis{{long_axis(piece)[0], long_axis(piece)[1]}};
      if (holds(field, axis) && length_of(axis) > 0) passes.push_back({axis});
    }
    if (area_of({part[0]}) - area_of(inside) < tol::area_cusp * tol::area_cusp) continue;
    for (const Polygon& line : lines_inside(rims, grown(part, job.radius, 10 * tol::area_chord)))
      if (Edges path = along(line, carriers); !path.empty()) passes.push_back({path});
  }
  return passes;
}

Result<Passes> passes_of(const Field& field, const Job& job) {
  const bool rows = job.scheme != Scheme::spiral_out && job.scheme != Scheme::spiral_in;
  const bool before = job.scheme == Scheme::contour_then_zigzag || job.scheme == Scheme::contour_then_comb;
  const bool after = job.scheme == Scheme::zigzag_then_contour || job.scheme == Scheme::comb_then_contour;
  auto passes = rows ? row_passes(field, job, before || after ? inset_of(job) : 0) : ring_passes(field, job);
  if (!passes) return passes;
  const Passes contour = before || after ? contour_passes(field) : Passes();
  if (before) passes->insert(passes->begin(), contour.begin(), contour.end());
  if (after) passes->insert(passes->end(), contour.begin(), contour.end());
  constexpr int rounds = 3;  // Each round cuts what the passes of the previous round left uncut.
  for (int round = 0; round < rounds && !job.watch.stop.requested(); ++round) {
    const Passes rest = rest_passes(field, job, *passes);
    if (rest.empty()) break;
    passes->insert(passes->end(), rest.begin(), rest.end());
  }
  if (job.direction == Direction::cw)
    for (Pass& pass : *passes)
      if (pass.closed) pass.path = reversed(pass.path);
  return passes;
}

}  // namespace kadr::area
