// The SL cycles 21 to 25 on the contours of cycle 14 with the data of cycle 20 (spec/heidenhain 12.12). The contours are subprograms, read
// by control/outline_run; the areas are cleared by the engine of `kadr mill` (path/pocketing). The manuals do not lay down the path:
// levels, walls, allowances and end point are those of the cycles. Used by control/heidenhain.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/ascii.h"
#include "base/tolerance.h"
#include "control/heidenhain/mill_path.h"
#include "control/outline_run.h"
#include "path/pocketing/field.h"
#include "path/pocketing/verify.h"

namespace kadr::heidenhain {
namespace {

constexpr std::size_t most_contours = 12, most_contour_steps = 200'000;

/// Removes the motions of the program's frame, because the cycle executes the path within it, and what else would act on the contour.
Status prepare(Interpreter& copy) {
  Heidenhain& own = heidenhain_of(copy);
  own.reset_frames();
  own.memory.calls_always = false;
  own.memory.cycle = -1;
  return own.set_frame(copy);
}

/// Works out the steps of one call of an SL cycle.
class ContourCycle {
 public:
  ContourCycle(Interpreter& m, const Heidenhain& own, Span where)
      : m_(m), own_(own), where_(where), plane_(m.modal.axes), unit_(m.unit_scale()), path_(begin_path()) {}

  std::vector<CycleStep> steps;

  Status run(int cycle) {
    const bool train = cycle == 25;
    if (!train && !own_.memory.has_contour_data)
      return fail(alarm(AlarmId::word_missing, where_, "CYCL DEF 20", std::string_view("CYCL DEF " + std::to_string(cycle))));
    if (own_.memory.contours.empty())
      return fail(alarm(AlarmId::word_missing, where_, "CYCL DEF 14", std::string_view("CYCL DEF " + std::to_string(cycle))));
    radius_ = own_.tool_radius(m_);
    if (cycle != 21)
      if (const auto needed = own_.cutter_radius(m_, where_); !needed) return fail(needed.error());
    KADR_TRY(take_levels(cycle));
    KADR_TRY(read_contours(train));
    path_.raise(height_);
    switch (cycle) {
      case 21: return drill();
      case 22: return clear();
      case 23: return floor();
      case 24: return walls();
      default: return along();
    }
  }

 private:
  double q(std::size_t index) const { return own_.memory.q[index]; }
  double given(std::size_t index, double otherwise) const { return own_.memory.given(index) ? q(index) * unit_ : otherwise; }
  /// Returns a value of cycle 20, mm; cycle 25 has these parameters itself.
  double data(std::size_t index, bool train) const { return (train ? q(index) : own_.memory.contour_data[index]) * unit_; }

  MillPath begin_path() {
    const Axes& at = m_.position.programmed;
    return {steps, plane_, in_plane(at, plane_), at[plane_.normal]};
  }

  Status take_levels(int cycle) {
    const bool train = cycle == 25, drills = cycle == 21;
    surface_ = data(5, train);
    height_ = data(7, train);
    depth_ = data(1, train);
    side_allowance_ = data(3, train);
    floor_allowance_ = train ? 0 : std::max(0.0, data(4, train));
    clearance_ = surface_ + (train ? 0 : std::fabs(data(6, train)));
    infeed_ = std::fabs(q(10) * unit_);
    plunge_ = q(11) * unit_, feed_ = q(12) * unit_;
    const bool climb = train || own_.memory.contour_data[9] >= 0;
    ccw_ = climb == (m_.modal.spindle != SpindleDir::ccw);
    if (!(depth_ < 0)) return fail(alarm(AlarmId::value_out_of_range, where_, "Q1", depth_ / unit_));
    if (!(height_ > surface_)) return fail(alarm(AlarmId::value_out_of_range, where_, "Q7", height_ / unit_));
    return plunge_ != 0 && (feed_ != 0 || drills) ? Status() : m_.feed_known(where_);
  }

  /// Reads the contours: a pocket if the tool is inside the contour, an island if it is outside. INFERRED: without RL and RR it is a
  /// pocket.
  Status read_contours(bool train) {
    for (const std::string& label : own_.memory.contours) {
      const auto outline = outline_of(m_, where_, [&](Interpreter& copy) -> Status {
        KADR_TRY(prepare(copy));
        return heidenhain_of(copy).call_subprogram(copy, label, where_);
      });
      if (!outline) return fail(outline.error());
      train_ = *outline;
      if (train) continue;
      Edges loop = outline->edges;
      const Vec2 end = loop.back().to;
      if (!is_closed(loop)) return fail(alarm(AlarmId::contour_not_closed, where_, std::string_view(label), end.x / unit_, end.y / unit_));
      loop.back().to = loop.front().from;
      const bool turns_left = area::area_of({area::flattened(loop, tol::contour_gap)}) > 0;
      const bool outside = outline->side != 0 && turns_left != (outline->side > 0);
      (outside ? islands_ : pockets_).push_back(std::move(loop));
    }
    if (train) return {};
    zones_ = area::zones_between(pockets_, islands_);
    return zones_.empty() ? Status(fail(too_large())) : Status();
  }

  Alarm too_large() const { return alarm(AlarmId::contour_tool_large, where_, 2 * radius_ / unit_); }

  area::Job job(double top, double bottom) const {
    area::Job made;
    made.radius = radius_;
    made.allowance = std::max(0.0, side_allowance_);
    const double factor = own_.memory.contour_data[2];
    made.step = std::clamp(factor > 0 ? factor : 1.0, 0.05, 1.9) * radius_;
    made.top = top;
    made.depth = top - bottom;
    made.layer = made.depth;
    made.clearance = height_ - top;
    made.direction = ccw_ ? area::Direction::ccw : area::Direction::cw;
    made.watch.stop = m_.program().limits().stop;
    return made;
  }

  Result<area::AreaPath> area_of_job(const area::Job& job) const {
    auto made = area::verified_path(zones_, job);
    if (made) return std::move(made->path);
    Alarm fault = made.error();
    if (fault.id == AlarmId::tool_does_not_fit) fault = too_large();
    fault.where = where_;
    return fail(fault);
  }

  /// Adds the moves of an area, which lies `lower` mm lower than it was computed; its moves at the clearance height stay there.
  Status follow(const area::AreaPath& area, double lower = 0) {
    if (steps.size() + area.moves.size() > most_contour_steps) return fail(alarm(AlarmId::cycle_endless, where_));
    Vec2 at = steps.empty() ? in_plane(m_.position.programmed, plane_) : in_plane(steps.back().to, plane_);
    for (const area::Move& move : area.moves) {
      const Vec2 to{move.to.x, move.to.y};
      const double feed = move.kind == area::MoveKind::rapid ? -1 : move.kind == area::MoveKind::plunge ? plunge_ : feed_;
      const double height = move.to.z > height_ - tol::same_point ? height_ : move.to.z - lower;
      if (move.bulge == 0) path_.slope(to, height, feed);
      else arc({at, to, move.bulge}, height, feed);
      at = to;
    }
    return {};
  }

  void arc(const Edge& edge, double height, double feed) {
    path_.helix(edge.to, height, area::circle_of(edge).centre, 2 * std::atan(std::fabs(edge.bulge)) / pi, edge.bulge < 0, feed);
  }
  void cut(const Edge& edge) {
    if (area::is_line(edge)) path_.move(edge.to, feed_);
    else arc(edge, path_.height(), feed_);
  }

  /// Cycle 21: drills where cycle 22 goes down, for a cutter with the radius of tool Q13, in steps of Q10.
  Status drill() {
    const auto cutter = static_cast<std::size_t>(std::lround(std::max(0.0, q(13))));
    const bool known = own_.memory.given(13) && cutter > 0 && cutter < m_.tables.offsets.size();
    if (known) radius_ = m_.tables.offsets[cutter].whole_radius();
    if (!(radius_ > 0)) return fail(alarm(AlarmId::cycle_tool_radius, where_, double(known ? cutter : m_.modal.tool)));
    area::Job all = job(surface_, surface_ + depth_ + floor_allowance_);
    all.plunge = area::Plunge::hole;
    const auto made = area_of_job(all);
    if (!made) return fail(made.error());
    pilot_radius = radius_;
    for (const Vec2 hole : made->holes) {
      path_.move(hole);
      path_.raise(clearance_);
      for (const double level : depths(all.top - all.depth)) {
        path_.raise(level, plunge_);
        path_.raise(clearance_);
        if (level > all.top - all.depth + tol::same_point) path_.raise(std::min(clearance_, level + stop_distance));
      }
      path_.raise(height_);
    }
    return {};
  }

  std::vector<double> depths(double bottom) const {
    std::vector<double> all;
    constexpr std::size_t most = 10'000;
    for (double at = surface_; at > bottom + tol::same_point && all.size() < most; all.push_back(at))
      at = infeed_ > 0 ? std::max(bottom, at - infeed_) : bottom;
    return all;
  }

  /// Cycle 22: clears the area down to the allowance on the floor.
  Status clear() {
    if (own_.memory.given(18) && q(18) != 0) m_.warn(warning(AlarmId::word_passed_over, where_, "Q18"));
    const double bottom = surface_ + depth_ + floor_allowance_;
    if (!(bottom < surface_)) return {};
    const bool drilled = own_.memory.pilot_radius > 0 && std::fabs(own_.memory.pilot_radius - radius_) < tol::same_point;
    std::optional<area::AreaPath> made;  // of a level as thick as `thickness`, below `top`
    double thickness = 0, top = 0, above = surface_;
    for (const double level : depths(bottom)) {
      if (!made || std::fabs(above - level - thickness) > tol::same_point) {
        area::Job one = job(above, level);
        if (drilled) one.plunge = area::Plunge::hole;
        auto path = area_of_job(one);
        if (!path) return fail(path.error());
        made = std::move(*path), thickness = above - level, top = above;
      }
      KADR_TRY(follow(*made, top - above));
      above = level;
    }
    path_.raise(height_);
    return {};
  }

  /// Cycle 23: cuts the floor at the depth.
  Status floor() {
    const double bottom = surface_ + depth_;
    area::Job all = job(bottom + std::max(floor_allowance_, least_layer), bottom);
    const auto made = area_of_job(all);
    if (!made) return fail(made.error());
    KADR_TRY(follow(*made));
    path_.raise(height_);
    return {};
  }

  /// Cycle 24: goes along each wall, at each level, to the allowance Q14.
  Status walls() {
    side_allowance_ = std::max(0.0, given(14, 0));
    if (own_.memory.given(9)) ccw_ = (q(9) >= 0) == (m_.modal.spindle != SpindleDir::ccw);
    const area::Job all = job(surface_, surface_ + depth_);
    const std::vector<double> levels = depths(surface_ + depth_);
    std::size_t count = 0;
    for (const area::Zone& zone : zones_)
      for (const area::Field& field : area::fields_of(zone, all))
        for (const Edges& loop : field.reach) {
          ++count;
          path_.raise(height_);
          for (const double level : levels) wall(field, ccw_ ? loop : area::reversed(loop), level);
          if (steps.size() > most_contour_steps) return fail(alarm(AlarmId::cycle_endless, where_));
        }
    if (count == 0) return fail(too_large());
    path_.raise(height_);
    return {};
  }

  /// One round of a wall from the middle of its longest edge, with quarters of a circle to it and from it where there is room.
  void wall(const area::Field& field, const Edges& loop, double level) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
      if (area::length_of(loop[i]) > area::length_of(loop[longest])) longest = i;
    const Edge& first = loop[longest];
    const Vec2 begin = area::at(first, 0.5), along = area::direction(first, 0.5);
    const Vec2 inwards = (ccw_ ? 1.0 : -1.0) * Vec2{-along.y, along.x};
    const double bulge = (ccw_ ? 1 : -1) * std::tan(pi / 8);
    Edges in, out;
    for (double size = radius_; size > 0.2 * radius_ && in.empty(); size /= 2) {
      const Edge to{begin + size * (inwards - along), begin, bulge}, from{begin, begin + size * (inwards + along), bulge};
      if (area::holds(field, {to, from})) in = {to}, out = {from};
    }
    if (path_.height() < clearance_) path_.raise(clearance_);
    path_.move(in.empty() ? begin : in[0].from);
    path_.raise(clearance_);
    path_.raise(level, plunge_);
    for (const Edge& edge : in) cut(edge);
    cut(area::section(first, 0.5, 1));
    for (std::size_t i = 1; i < loop.size(); ++i) cut(loop[(longest + i) % loop.size()]);
    cut(area::section(first, 0, 0.5));
    for (const Edge& edge : out) cut(edge);
  }

  /// Cycle 25: along an open or closed contour, next to it with RL and RR, at each level. Q15: 1 climb, -1 up-cut, 0 to and fro.
  Status along() {
    if (own_.memory.contours.size() != 1)
      return fail(alarm(AlarmId::value_out_of_range, where_, "CYCL DEF 14", double(own_.memory.contours.size())));
    const double distance = train_.side == 0 ? 0 : radius_ + side_allowance_;
    if (distance < 0) return fail(too_large());
    const auto made = offset_outline(m_, train_.edges, distance, train_.side, CornerJoin::arc, where_);
    if (!made) return fail(made.error());
    const double way = own_.memory.given(15) ? q(15) : 1;
    const bool climbs = train_.side == 0 || (train_.side > 0) == (m_.modal.spindle != SpindleDir::ccw);
    bool forwards = way == 0 || (way > 0) == climbs;
    bool first = true;
    for (const double level : depths(surface_ + depth_)) {
      const Edges& edges = *made;
      const Edges now = forwards ? edges : area::reversed(edges);
      if (steps.size() + now.size() > most_contour_steps) return fail(alarm(AlarmId::cycle_endless, where_));
      if (first || way != 0) {
        path_.raise(height_);
        path_.move(now.front().from);
        path_.raise(surface_ + std::min(height_ - surface_, near_surface));
      }
      path_.raise(level, plunge_);
      for (const Edge& edge : now) cut(edge);
      if (way == 0) forwards = !forwards;
      first = false;
    }
    path_.raise(height_);
    return {};
  }

 public:
  double pilot_radius = 0;  // radius of the cutter for which cycle 21 has drilled, mm

 private:
  static constexpr double stop_distance = 0.6;  // mm above the depth reached at which rapid motion ends, as in cycle 1
  static constexpr double least_layer = 1;      // mm above the floor at which cycle 23 begins to go down
  static constexpr double near_surface = 2;     // mm above the surface at which rapid motion ends in cycle 25: INFERRED

  Interpreter& m_;
  const Heidenhain& own_;
  Span where_;
  PlaneAxes plane_;
  double unit_;
  MillPath path_;
  double radius_ = 0, surface_ = 0, height_ = 0, clearance_ = 0, depth_ = 0, infeed_ = 0;
  double side_allowance_ = 0, floor_allowance_ = 0, plunge_ = 0, feed_ = 0;
  bool ccw_ = true;  // direction of travel around an area
  std::vector<Edges> pockets_, islands_;
  std::vector<area::Zone> zones_;
  Outline train_;  // the contour of cycle 25
};

}  // namespace

/// Cycle 14: CONTOUR LABEL 1/2/"NAME".
Status Heidenhain::take_contours(const KlartextBlock& block, Span where) {
  if (block.part == 1) memory.contours.clear();
  const std::string& text = block.text;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      const std::size_t end = text.find('"', i + 1);
      memory.contours.push_back(text.substr(i, end == std::string::npos ? end : end - i));
      i = std::min(end, text.size());
    } else if (is_digit(text[i])) {
      std::size_t end = i;
      while (end < text.size() && is_digit(text[end])) ++end;
      memory.contours.push_back(text.substr(i, end - i));
      i = end;
    }
  }
  memory.pilot_radius = 0;
  if (memory.contours.size() <= most_contours) return {};
  const auto count = static_cast<double>(memory.contours.size());
  memory.contours.clear();
  return fail(alarm(AlarmId::value_out_of_range, where, "CYCL DEF 14", count));
}

/// Cycle 20: its parameters keep their values at the definition.
void Heidenhain::take_contour_data() {
  for (std::size_t i = 1; i < memory.contour_data.size(); ++i) memory.contour_data[i] = std::isnan(memory.q[i]) ? 0 : memory.q[i];
  memory.has_contour_data = true;
  memory.pilot_radius = 0;
}

Status Heidenhain::mill_contours(Interpreter& m, Span where) {
  const std::string name = "CYCL DEF " + std::to_string(memory.cycle);
  if (m.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, where, std::string_view(name)));
  if (m.transform.leaves(m.modal.axes) || m.transform.distorts(m.modal.axes))
    return fail(alarm(AlarmId::not_together, where, "CYCL DEF 26", std::string_view(name)));
  ContourCycle made(m, *this, where);
  KADR_TRY(made.run(memory.cycle));
  memory.pilot_radius = memory.cycle == 21 ? made.pilot_radius : memory.pilot_radius;
  m.running = std::make_unique<CycleSteps>(std::move(made.steps));
  return {};
}

}  // namespace kadr::heidenhain
