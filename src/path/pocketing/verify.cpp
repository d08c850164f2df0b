// This file checks a tool path against the zones. The path may come from any source, for example from a program that was read back. Used by
// cli/mill.

#include "path/pocketing/verify.h"

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "path/pocketing/field.h"
#include "path/pocketing/sweep.h"

namespace kadr::area {
namespace {

constexpr double verified_chord = 10 * tol::area_chord;  // chord tolerance, mm, for the computation of areas; cusps are far larger
// Z levels whose difference is below this value, mm, count as equal, because the program rounds levels to the digits of the Z word.
constexpr double same_level = tol::area_cusp;

class Check {
 public:
  Check(const std::vector<Zone>& zones, const Job& job) : job_(job), levels_(levels_of(job)), cut_(levels_.size()) {
    outcome_.required = job.radius + job.allowance;
    outcome_.nearest_wall = std::numeric_limits<double>::infinity();
    for (const Zone& zone : zones) add(zone);
    room_ = Room(grown(allowed_, tol::area_wall, tol::area_chord));
  }

  Outcome run(const std::vector<Move>& moves) {
    for (std::size_t i = 1; i < moves.size() && !stopped(); ++i) {
      take(moves[i - 1].to, moves[i]);
      job_.watch.report_progress(Stage::verification, double(i) / double(moves.size()));
    }
    for (std::size_t i = 0; i < levels_.size() && !stopped(); ++i) coverage(levels_[i], cut_[i]);
    if (stopped()) outcome_.fault = alarm(AlarmId::interrupted, {});
    return outcome_;
  }

 private:
  bool stopped() const { return job_.watch.stop.requested(); }

  void add(const Zone& zone) {
    Polygons area = flattened(zone.loops, tol::area_chord), open, walls;
    outcome_.out_of_reach += area_of(area);
    for (const Edges& loop : zone.loops)
      for (const Edge& e : loop) {
        if (!e.open) walls_.push_back({e, bounds_of({e})});
        (e.open ? open : walls).push_back(flattened({e}, tol::area_chord));
      }
    allowed_ = joined(allowed_, joined(area, swept(open, job_.radius + job_.overrun, tol::area_chord)));
    Polygons left = job_.allowance > 0 ? less(area, swept(walls, job_.allowance, verified_chord)) : area;
    outcome_.out_of_reach += area_of(left) - area_of(area);
    Polygons required = reachable(area, open, walls);
    // The areas of the fields are added for a slot whose width is exactly the tool's diameter, which reachable() ignores.
    for (const Field& field : fields_of(zone, job_)) required = joined(required, field.required);
    outcome_.out_of_reach = std::max(0.0, outcome_.out_of_reach - area_of(common(required, left)));
    required_ = joined(required_, required);
  }

  /// Returns the part of the zone that a tool can cut without coming too near to a wall, from inside the zone or from beyond its open
  /// sides. The path was computed from the fields (Field). This computation does not use them, so it detects their errors. Passages wider
  /// than the tool by less than tol::area_wall are ignored.
  Polygons reachable(const Polygons& area, const Polygons& open, const Polygons& walls) const {
    const double off_walls = job_.radius + job_.allowance + tol::area_wall;
    Polygons centres = joined(area, swept(open, job_.radius, verified_chord));
    if (!walls.empty()) centres = less(centres, swept(walls, off_walls, tol::area_chord));
    return common(area, grown(centres, job_.radius, verified_chord));
  }

  void fault(const Alarm& alarm) {
    if (!outcome_.fault) outcome_.fault = alarm;
  }

  void take(Vec3 from, const Move& move) {
    const bool below = std::min(from.z, move.to.z) < job_.top - tol::level;
    const Edge e{{from.x, from.y}, {move.to.x, move.to.y}, move.bulge};
    const double flat = length(e.to - e.from);
    if (move.kind != MoveKind::rapid) outcome_.length += std::hypot(length_of(e), move.to.z - from.z);
    if (!below) return;
    if (move.kind == MoveKind::rapid && flat > tol::area_wall) fault(alarm(AlarmId::mill_rapid, {}, move.to.x, move.to.y, move.to.z));
    keep_off(e, move.to.z);
    stay_inside(e, move.to.z);
    if (move.kind == MoveKind::rapid) return;
    for (std::size_t i = 0; i < levels_.size(); ++i)
      if (std::abs(move.to.z - levels_[i]) < same_level && std::abs(from.z - levels_[i]) < same_level) cut_[i].push_back(e);
  }

  void keep_off(const Edge& e, double level) {
    const Bounds box = bounds_of({e});
    for (const auto& [wall, around] : walls_) {
      if (!around.near(box, std::min(outcome_.nearest_wall, 1e6))) continue;
      outcome_.nearest_wall = std::min(outcome_.nearest_wall, distance(e, wall));
    }
    if (outcome_.nearest_wall < outcome_.required - tol::area_wall)
      fault(alarm(AlarmId::mill_wall, {}, outcome_.nearest_wall, outcome_.required, level));
  }

  void stay_inside(const Edge& e, double level) {
    if (outcome_.fault) return;
    const Polygon corners = flattened({e}, tol::area_chord);
    if (room_.surely_holds(corners)) return;
    for (const Polygon& line : lines_outside({corners}, room_.area()))
      if (length(line.back() - line.front()) > tol::area_wall) fault(alarm(AlarmId::mill_wall, {}, 0.0, outcome_.required, level));
  }

  void coverage(double level, const Edges& cut) {
    Polygons lines;
    for (const Edge& e : cut) {
      Polygon corners = flattened({e}, tol::area_chord);
      if (!lines.empty() && length(lines.back().back() - corners.front()) < tol::same_point)
        lines.back().insert(lines.back().end(), corners.begin() + 1, corners.end());
      else lines.push_back(std::move(corners));
    }
    double sum = 0;
    for (const Polygons& part : parts_of(less(required_, swept_all(lines, job_.radius + tol::area_cusp, verified_chord, job_.watch)))) {
      const double area = area_of(part);
      if (area > tol::area_cusp * tol::area_cusp) sum += area;
    }
    outcome_.uncut = std::max(outcome_.uncut, sum);
    if (sum > tol::area_cusp * job_.radius) fault(alarm(AlarmId::mill_uncut, {}, sum, level));
  }

  const Job& job_;
  Outcome outcome_;
  std::vector<std::pair<Edge, Bounds>> walls_;
  Polygons allowed_, required_;
  Room room_;  // the area that the tool may cut (allowed_), enlarged by the tolerance tol::area_wall
  std::vector<double> levels_;
  std::vector<Edges> cut_;  // The edges of the tool path along which the tool cuts, one list per Z level.
};

}  // namespace

Outcome verified(const std::vector<Zone>& zones, const Job& job, const std::vector<Move>& moves) { return Check(zones, job).run(moves); }

Result<Verified> verified_path(const std::vector<Zone>& zones, const Job& job) {
  constexpr int max_tries = 10;
  constexpr double smaller = 0.8;
  Job tried = job;
  for (int i = 0;; ++i, tried.step *= smaller) {
    auto path = area_path(zones, tried);
    if (!path) return fail(path.error());
    Outcome outcome = verified(zones, tried, path->moves);
    if (!outcome.fault) return Verified{std::move(*path), outcome};
    if (outcome.fault->id != AlarmId::mill_uncut || i == max_tries) return fail(*outcome.fault);
  }
}

}  // namespace kadr::area
