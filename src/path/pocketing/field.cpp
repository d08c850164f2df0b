// Field is a connected area of one zone that the tool's centre may reach. Used by the other folders of path.

#include "path/pocketing/field.h"

#include <algorithm>

#include "base/tolerance.h"
#include "path/pocketing/sweep.h"

namespace kadr::area {
namespace {

constexpr double chord = tol::area_chord;

Edges all_edges(const std::vector<Edges>& loops) {
  Edges all;
  for (const Edges& loop : loops) all.insert(all.end(), loop.begin(), loop.end());
  return all;
}

/// Appends the parts of a loop that are walls to `lines` as polylines; if `open` is true, the parts that are open sides. A polyline around
/// the whole loop repeats its first two corners at its end.
void add_sections(const Edges& loop, bool open, Polygons& lines) {
  const auto begin = std::find_if(loop.begin(), loop.end(), [&](const Edge& e) { return e.open != open; });
  if (begin == loop.end()) {
    Polygon around = flattened(loop, chord);
    around.insert(around.end(), {around[0], around[1]});
    lines.push_back(around);
    return;
  }
  Edges section;
  const auto flush = [&] {
    if (!section.empty()) lines.push_back(flattened(section, chord));
    section.clear();
  };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Edge& e = loop[(static_cast<std::size_t>(begin - loop.begin()) + i) % loop.size()];
    if (e.open == open) section.push_back(e);
    else flush();
  }
  flush();
}

Polygons sections(const Zone& zone, bool open) {
  Polygons lines;
  for (const Edges& loop : zone.loops) add_sections(loop, open, lines);
  return lines;
}

std::vector<Edges> recovered(const Polygons& areas, const Carriers& carriers) {
  std::vector<Edges> loops;
  for (const Polygon& p : areas)
    if (Edges loop = carriers.recovered(p, true); loop.size() > 1) loops.push_back(std::move(loop));
  return loops;
}

/// Computes the fields of one zone: the connected areas that the tool's centre may reach.
class Fields {
 public:
  Fields(const Zone& zone, const Job& job, double off_walls) : job_(job), off_walls_(off_walls) {
    for (const Edges& loop : zone.loops)
      for (const Edge& e : loop) (e.open ? open_ : walls_).push_back(e);
    area_ = flattened(zone.loops, chord);
    open_lines_ = sections(zone, true);
    next_to_walls_ = swept(sections(zone, false), off_walls, chord);
  }

  std::vector<Field> make() const {
    const double beyond = job_.radius + job_.overrun, passes_beyond = std::max(0.0, job_.radius - job_.step);
    const Polygons work = centres(passes_beyond);
    std::vector<Field> fields;
    for (const Polygons& part : parts_of(centres(beyond))) {
      Field field;
      field.walls = walls_;
      field.zone = area_;
      field.reach = recovered(part, carriers(beyond));
      field.reach_area = flattened(field.reach, chord);
      if (field.reach.empty()) continue;
      field.work = open_.empty() ? field.reach : recovered(common(work, part), carriers(passes_beyond));
      // If the reduced area is empty, the passes cover the whole area that the tool's centre may reach. The tool's centre then stays
      // outside the zone, and the tool cuts through an open side only.
      if (field.work.empty()) field.work = field.reach;
      field.work_area = flattened(field.work, chord);
      field.roomy = Room(grown(field.reach_area, tol::area_wall / 2, chord));
      field.required = common(grown(field.reach_area, job_.radius, chord), area_);
      if (field.required.empty()) continue;
      fields.push_back(std::move(field));
    }
    return fields;
  }

 private:
  Polygons centres(double beyond) const {
    const Polygons extended = beyond > 0 && !open_.empty() ? joined(area_, swept(open_lines_, beyond, chord, Ends::cut)) : area_;
    return walls_.empty() ? extended : less(extended, next_to_walls_);
  }
  Carriers carriers(double beyond) const {
    Carriers all;
    all.add(walls_, off_walls_);
    all.add(open_, beyond);
    return all;
  }

  const Job& job_;
  double off_walls_;
  Edges walls_, open_;
  Polygons area_, open_lines_, next_to_walls_;
};

}  // namespace

std::vector<Field> fields_of(const Zone& zone, const Job& job) {
  const double off_walls = job.radius + job.allowance;
  std::vector<Field> fields = Fields(zone, job, off_walls).make();
  // If no field is found, the required distance from the walls is reduced by a half of tol::area_wall. This allows a slot whose width is
  // exactly the tool's diameter.
  if (fields.empty()) fields = Fields(zone, job, off_walls - tol::area_wall / 2).make();
  return fields;
}

bool holds(const Field& field, const Edges& path) { return field.roomy.holds(flattened(path, chord), chord); }

bool in_air(const Field& field, const Job& job, Vec2 p) {
  if (contains(field.zone, p)) return false;
  for (const Polygon& loop : field.zone)
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (distance(Edge{loop[i], loop[(i + 1) % loop.size()]}, p) < job.radius) return false;
  return true;
}

std::vector<Edges> rings_at(const Field& field, double by) {
  if (by <= 0) return field.work;
  Carriers carriers;
  carriers.add(all_edges(field.work), by);
  return recovered(grown(field.work_area, -by, chord), carriers);
}

Polygons uncut(const Field& field, const Job& job, const Polygons& paths) {
  Polygons left = less(field.required, swept_all(paths, job.radius + tol::area_cusp, 10 * chord, job.watch));
  std::erase_if(left, [](const Polygon& p) { return std::abs(area_of({p})) < tol::area_cusp * tol::area_cusp; });
  return left;
}

}  // namespace kadr::area
