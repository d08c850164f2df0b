// This file creates the moves that execute the passes of each field, layer by layer. Plunges, links and lifts connect the passes. The entry
// point is area_path().

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "path/pocketing/links.h"
#include "path/pocketing/plunge_ramp.h"
#include "path/pocketing/sweep.h"

namespace kadr::area {
namespace {

constexpr double above = 1;     // Height, mm, above the ground that the previous layer left, at which rapid motion ends.
constexpr double rough = 0.02;  // chord tolerance, mm, of the checks whether material remains

class Layers {
 public:
  Layers(const Job& job, AreaPath& path) : job_(job), path_(path) {}

  bool uses_hole() const { return hole_used_; }

  void mill(const Field& field, Passes passes) {
    field_ = &field;
    const std::vector<double> levels = levels_of(job_);
    path_.layers = levels.size();
    ground_ = job_.top;
    begin_first(passes.front());
    lift();
    for (const double level : levels) {
      level_ = level;
      cut_.clear();
      for (std::size_t k = 0; k < passes.size() && !job_.watch.stop.requested(); ++k) {
        pass(passes[k], k == 0);
        job_.watch.report_progress(Stage::path, double(k) / double(passes.size()));
      }
      ground_ = level;
    }
    leave(passes.back());
    lift();
  }

 private:
  Vec2 here() const { return {at_.x, at_.y}; }
  void go(MoveKind kind, Vec3 to, double bulge = 0) {
    if (length(to - at_) < tol::same_point && !path_.moves.empty()) return;
    path_.moves.push_back({kind, to, bulge});
    at_ = to;
  }
  void cut(const Edges& path) {
    for (const Edge& e : path) {
      go(MoveKind::feed, {e.to.x, e.to.y, level_}, e.bulge);
      cut_.push_back(e);
    }
    if (!path.empty()) out_ = direction(path.back(), 1);
  }
  void lift() {
    if (!path_.moves.empty()) go(MoveKind::rapid, {at_.x, at_.y, job_.top + job_.clearance});
    out_.reset();
  }

  /// Chooses the start of the first ring; the start is the same in all layers. It is near the given hole, or near a position outside the
  /// material, or otherwise at the middle of the longest edge of the ring.
  void begin_first(Pass& first) {
    const bool own_hole = job_.plunge == Plunge::hole && job_.hole && contains(field_->roomy.area(), *job_.hole);
    if (!first.closed) return;
    if (own_hole) first.path = begun_near(first.path, *job_.hole);
    else if (const auto air = air_near(first.path.front().from)) first.path = begun_near(first.path, *air);
    else first.path = begun_at_longest(first.path);
  }

  void pass(const Pass& pass, bool first) {
    if (first) return first_pass(pass);
    // If the start of the pass is near the tool, a lift would end at about the position where it began, so the tool is not lifted.
    if (!pass.lifted || length(pass.path.front().from - here()) < job_.radius)
      if (const auto begun = pass_start_from(*field_, job_, pass, here(), out_)) {
        cut(begun->link);
        return cut(begun->path);
      }
    leave(pass);
    enter(pass.path, true);
    cut(pass.path);
  }

  void first_pass(const Pass& pass) {
    const bool down = at_.z < job_.top;
    const bool turn =
        down && !pass.closed && !pass.lifted && length(pass.path.back().to - here()) < length(pass.path.front().from - here());
    const Edges path = turn ? reversed(pass.path) : pass.path;
    enter(path, false);
    cut(path);
  }

  /// Moves the tool away from a wall before the tool is lifted.
  void leave(const Pass& pass) {
    if (!pass.closed || cut_.empty()) return;
    if (const auto arc = arc_out_of(*field_, job_, cut_)) cut({*arc});
  }

  /// Moves the tool down to the level of the layer and to the start of the path. `again` is true if the tool has already cut in this layer.
  void enter(const Edges& path, bool again) {
    const Vec2 start = path.front().from;
    if (in_air(*field_, job_, start) || (again && cleared(start))) return descend(start, again);
    if (const auto air = air_near(start)) {
      descend(*air, again);
      return cut({{*air, start}});
    }
    switch (job_.plunge) {
      case Plunge::hole: return enter_by_hole(start, again);
      case Plunge::tangential:
        if (const auto arc = arc_into(*field_, job_, path)) {
          path_.plunges.straight += again && cleared(arc->from) ? 0 : 1;
          descend(arc->from, again);
          return cut({*arc});
        }
        return descend_ramp(path, again);
      case Plunge::ramp: return descend_ramp(path, again);
    }
  }

  /// Moves the tool to the start in the plane, from a position that is already cut on this level. If there is no such position, the tool
  /// plunges through a hole.
  void enter_by_hole(Vec2 start, bool again) {
    if (const auto cut_place = again ? cut_place_near(start) : std::nullopt) {
      descend(*cut_place, again);
      return cut({{*cut_place, start}});
    }
    Vec2 hole = start;
    std::optional<Edges> link;
    if (job_.hole && contains(field_->roomy.area(), *job_.hole)) {
      link = link_between(*field_, *job_.hole, start, 1e9);
      if (link) hole = *job_.hole, hole_used_ = true;
    }
    drill_before(hole);
    descend(hole, again);
    if (link) cut(*link);
  }

  void drill_before(Vec2 hole) {
    ++path_.plunges.drilled;
    if (std::none_of(path_.holes.begin(), path_.holes.end(), [&](Vec2 h) { return length(h - hole) < tol::contour_gap; }))
      path_.holes.push_back(hole);
  }

  /// Plunges through a predrilled hole, because there is no clearance for a ramp. A hole of AreaPath::holes is used if the tool can reach
  /// the start from this hole.
  void enter_drilled(Vec2 start, bool again) {
    ++path_.plunges.no_room;
    for (const Vec2 hole : path_.holes)
      if (const auto link = link_between(*field_, hole, start, 6 * job_.radius)) {
        drill_before(hole);
        descend(hole, again);
        return cut(*link);
      }
    drill_before(start);
    descend(start, again);
  }

  /// Moves the tool to a position over `point`, above the material or above the ground that the previous layer left, and then down.
  void descend(Vec2 point, bool again) {
    approach(point, again);
    go(MoveKind::plunge, {point.x, point.y, level_});
  }

  void approach(Vec2 point, bool again) {
    const double detour = again ? job_.radius - length(point - here()) : 6 * job_.radius;
    if (at_.z < job_.top && detour > 0)
      if (const auto link = link_between(*field_, here(), point, detour)) {
        for (const Edge& e : *link) go(MoveKind::feed, {e.to.x, e.to.y, at_.z}, e.bulge);
        return;
      }
    if (at_.z < job_.top + job_.clearance) {
      if (again) ++path_.lifts;
      lift();
    }
    go(MoveKind::rapid, {point.x, point.y, job_.top + job_.clearance});
    go(MoveKind::rapid, {point.x, point.y, std::min(ground_ + above, job_.top + job_.clearance)});
  }

  void descend_ramp(const Edges& path, bool again) {
    const auto ramp = ramp_for(*field_, job_, path, ground_ - level_);
    if (!ramp) return enter_drilled(path.front().from, again);
    ++(ramp->round ? path_.plunges.helices : path_.plunges.ramps);
    const Vec2 start = path.front().from;
    approach(start, again);
    go(MoveKind::plunge, {start.x, start.y, ground_});
    down_ramp(*ramp);
    go(MoveKind::plunge, {start.x, start.y, level_});
  }

  /// Moves the tool down in as many strokes or revolutions as necessary. Every corner of the ramp is at a level that the control's Z word
  /// can express, so that no motion is steeper than the job's ramp angle after rounding.
  void down_ramp(const Ramp& ramp) {
    const Polygon& corners = ramp.corners;
    const double drop = ground_ - level_, slope = std::tan(job_.ramp_deg * rad_per_deg), step = job_.level_step;
    // Limit of the number of strokes. The limit is needed if the rounding of Z prevents progress between close corners. The last motions
    // are then as steep as necessary.
    const int most = 4 * ramp.times + 4;
    double gone = 0, z = ground_;
    for (int i = 0; i < ramp.times || (z > level_ && i < most) || (!ramp.round && i % 2 == 1); ++i)
      for (std::size_t k = 1; k < corners.size(); ++k) {
        const bool back = !ramp.round && i % 2 == 1;
        const Vec2 a = back ? corners[corners.size() - k] : corners[k - 1];
        const Vec2 b = back ? corners[corners.size() - 1 - k] : corners[k];
        gone += length(b - a);
        const double even = ground_ - drop * std::min(1.0, gone / ramp.along);
        z = step > 0 ? std::max({level_, sayable(even), sayable(z - std::max(0.0, length(b - a) - 2 * step) * slope)}) : even;
        go(MoveKind::plunge, {b.x, b.y, z});
      }
  }

  /// Returns the level `z`, rounded up to a level that a Z word can express.
  double sayable(double z) const { return job_.level_step * std::ceil(z / job_.level_step - tol::tangential); }

  /// Returns true if no material is left on this level under a tool at `point`.
  bool cleared(Vec2 point) const {
    for (const Edge& e : cut_)
      // The tool has already cut along an edge through this point, so no material is left here.
      if (distance(e, point) < tol::same_point) return true;
    Polygons near;
    const Bounds tool{point - Vec2{job_.radius, job_.radius}, point + Vec2{job_.radius, job_.radius}};
    for (const Edge& e : cut_)
      if (bounds_of({e}).near(tool, job_.radius)) near.push_back(flattened({e}, rough));
    const Polygon disk = flattened(
        {{point - Vec2{job_.radius, 0}, point + Vec2{job_.radius, 0}, 1}, {point + Vec2{job_.radius, 0}, point - Vec2{job_.radius, 0}, 1}},
        rough);
    const Polygons left =
        less(common({disk}, field_->zone), swept_all(near, job_.radius + tol::area_cusp, rough, Watch{job_.watch.stop, {}}));
    return area_of(left) < tol::area_cusp * job_.radius;
  }

  /// Returns the nearest point that the tool has already cut on this level and from which the tool can move straight to `start`; nullopt if
  /// there is no such point.
  std::optional<Vec2> cut_place_near(Vec2 start) const {
    std::vector<Vec2> points;
    for (const Edge& e : cut_) points.push_back(at(e, nearest_part(e, start)));
    std::sort(points.begin(), points.end(), [&](Vec2 a, Vec2 b) { return length(a - start) < length(b - start); });
    for (const Vec2 p : points) {
      if (length(p - start) > 4 * job_.radius) break;
      if (holds(*field_, {{p, start}})) return p;
    }
    return std::nullopt;
  }

  /// Returns a point outside the material from which the tool can move straight to `start`; nullopt if there is no such point.
  std::optional<Vec2> air_near(Vec2 start) const {
    if (field_->roomy.empty()) return std::nullopt;
    std::vector<Vec2> points;
    for (const Edges& loop : field_->reach)
      for (const Edge& e : loop)
        for (const double part : {0.0, 0.5, nearest_part(e, start)}) points.push_back(at(e, part));
    std::sort(points.begin(), points.end(), [&](Vec2 a, Vec2 b) { return length(a - start) < length(b - start); });
    for (const Vec2 p : points) {
      if (length(p - start) > 4 * (job_.radius + job_.overrun)) break;
      if (in_air(*field_, job_, p) && holds(*field_, {{p, start}})) return p;
    }
    return std::nullopt;
  }

  const Job& job_;
  AreaPath& path_;
  const Field* field_ = nullptr;
  Vec3 at_{0, 0, 1e9};
  double ground_ = 0, level_ = 0;
  Edges cut_;  // edges of the tool's path that are already cut on this level
  std::optional<Vec2> out_;
  bool hole_used_ = false;
};

Result<AreaPath> milled(const std::vector<Field>& fields, std::vector<Passes> passes, const Job& job) {
  AreaPath path;
  path.fields = fields.size();
  path.step = job.step;
  Layers layers(job, path);
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!passes[i].empty()) layers.mill(fields[i], std::move(passes[i]));
  if (job.watch.stop.requested()) return fail(alarm(AlarmId::interrupted, {}));
  if (path.moves.empty()) return fail(alarm(AlarmId::tool_does_not_fit, {}, 2 * job.radius));
  if (job.hole && job.plunge == Plunge::hole && !layers.uses_hole()) return fail(alarm(AlarmId::mill_hole, {}, job.hole->x, job.hole->y));
  return path;
}

}  // namespace

std::vector<double> levels_of(const Job& job) {
  const int layers = std::max(1, static_cast<int>(std::ceil(job.depth / job.layer - tol::tangential)));
  std::vector<double> levels;
  for (int i = 1; i <= layers; ++i) levels.push_back(job.top - job.depth * i / layers);
  return levels;
}

Result<AreaPath> area_path(const std::vector<Zone>& zones, const Job& job) {
  std::vector<Field> fields;
  for (const Zone& zone : zones)
    for (Field& field : fields_of(zone, job)) fields.push_back(std::move(field));
  std::vector<Passes> passes;
  for (const Field& field : fields) {
    auto covering = passes_of(field, job);
    if (job.watch.stop.requested()) return fail(alarm(AlarmId::interrupted, {}));
    if (!covering) return tl::unexpected(covering.error());
    passes.push_back(std::move(*covering));
  }
  return milled(fields, std::move(passes), job);
}

std::vector<Zone> slot_zones(const std::vector<Edges>& lines, double radius) {
  Polygons corners;
  Carriers carriers;
  for (const Edges& line : lines) {
    corners.push_back(flattened(line, tol::area_chord));
    carriers.add(line, radius);
  }
  std::vector<Zone> zones;
  for (const Polygons& part : parts_of(swept(corners, radius, tol::area_chord))) {
    zones.emplace_back();
    for (const Polygon& p : part) zones.back().loops.push_back(carriers.recovered(p, true));
  }
  return zones;
}

Result<AreaPath> slot_path(const std::vector<Edges>& lines, const Job& job) {
  std::vector<Field> fields;
  for (const Zone& zone : slot_zones(lines, job.radius + job.allowance)) {
    fields.emplace_back();
    fields.back().zone = flattened(zone.loops, tol::area_chord);
  }
  std::vector<Passes> passes(fields.size());
  for (const Edges& line : lines)
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (contains(fields[i].zone, at(line[0], 0.5))) {
        passes[i].push_back({line});
        const Polygons room = swept({flattened(line, tol::area_chord)}, tol::area_wall / 2, tol::area_chord);
        fields[i].roomy = Room(joined(fields[i].roomy.area(), room));
      }
  return milled(fields, std::move(passes), job);
}

}  // namespace kadr::area
