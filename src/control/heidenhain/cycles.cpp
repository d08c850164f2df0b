// The steps of the drilling cycles and patterns (spec/heidenhain 12.2 to 12.8). Used by control/heidenhain.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/heidenhain/area_cycles.h"
#include "control/heidenhain/cycle_steps.h"

namespace kadr::heidenhain {
namespace {

constexpr std::size_t most_drilling_steps = 100'000;

}  // namespace

CycleMaker::CycleMaker(BlockContext& m, const Heidenhain& own, Span where)
    : m_(m), own_(own), where_(where), unit_(m.unit_scale()), plane_(m.modal.axes) {
  at_ = {m.position.programmed[plane_.first], m.position.programmed[plane_.second]};
}

void CycleMaker::rapid(double to) {
  CycleStep& step = steps.emplace_back();
  step.named = AxisMask{1} << plane_.normal;
  step.to[plane_.normal] = to;
}

void CycleMaker::feed(double to, double value) {
  rapid(to);
  steps.back().kind = CycleStep::Kind::feed;
  steps.back().value = value;
}

/// The way out at Q208: 0 is the feed of plunging; MAX, and what is faster than any feed, is rapid.
void CycleMaker::out(double to, double value, double fallback) {
  if (value < 0) rapid(to);
  else feed(to, value > 0 ? value : fallback);
}

void CycleMaker::in_plane(Vec2 to) {
  CycleStep& step = steps.emplace_back();
  step.named = AxisMask{1} << plane_.first | AxisMask{1} << plane_.second;
  step.to[plane_.first] = to.x;
  step.to[plane_.second] = to.y;
  at_ = to;
}

void CycleMaker::dwell(double seconds) {
  if (!(seconds > 0)) return;
  CycleStep& step = steps.emplace_back();
  step.kind = CycleStep::Kind::dwell;
  step.value = seconds;
}

void CycleMaker::spindle(SpindleDir dir, double angle) {
  CycleStep& step = steps.emplace_back();
  step.kind = CycleStep::Kind::spindle;
  step.dir = dir;
  step.angle = angle;
}

void CycleMaker::tap(double to, double pitch) {
  feed(to, std::fabs(pitch) * m_.modal.rpm);
  steps.back().taps = true;
}

void CycleMaker::levels(double surface, double clearance, double depth) {
  surface_ = surface;
  clearance_ = surface + clearance;
  bottom_ = surface + depth;
}

void CycleMaker::leave() {
  if (second_ > clearance_ + tol::same_point) rapid(second_);
}

/// 200: infeeds to the depth, each from Q200 above the depth reached (spec/heidenhain 12.2).
void CycleMaker::drill() {
  const double step = length(202), depth = surface_ - bottom_;
  double reached = surface_;
  rapid(clearance_);
  while (reached > bottom_ + tol::same_point && steps.size() < most_drilling_steps) {
    if (reached < surface_) {
      rapid(clearance_);
      dwell(q(210));
      rapid(reached + length(200));
    }
    reached = !(step > 0) || step >= depth ? bottom_ : std::max(bottom_, reached - step);
    feed(reached, feed_of(206));
  }
  dwell(q(211));
  rapid(clearance_);
  leave();
}

/// 203: with a decrement, chip breaking and a feed of its own for the way out (spec/heidenhain 12.4).
void CycleMaker::universal() {
  double step = length(202), reached = surface_;
  int breaks = 0;
  rapid(clearance_);
  while (reached > bottom_ + tol::same_point && steps.size() < most_drilling_steps) {
    if (reached < surface_) {
      if (breaks < q(213)) {
        feed(reached + length(256), feed_of(206));
        ++breaks;
      } else {
        out(clearance_, feed_of(208), feed_of(206));
        dwell(q(210));
        rapid(reached + length(200));
        breaks = 0;
      }
    }
    reached = step > 0 ? std::max(bottom_, reached - step) : bottom_;
    feed(reached, feed_of(206));
    step = std::max(step - length(212), std::max(length(205), q(212) > 0 ? 0.001 : step));
  }
  dwell(q(211));
  out(clearance_, feed_of(208), feed_of(206));
  leave();
}

/// 205: deep drilling from Q379, with chip breaking by Q257 and a stop distance above the depth reached (spec/heidenhain 12.4).
void CycleMaker::peck() {
  double step = length(202), reached = surface_ - std::fabs(length(379));
  const double whole = reached - bottom_;
  rapid(clearance_);
  if (q(379) != 0) feed(reached + length(200), feed_of(253));
  const double start = reached;
  while (reached > bottom_ + tol::same_point && steps.size() < most_drilling_steps) {
    if (reached < start) {
      rapid(clearance_);
      const double part = whole > 0 ? (start - reached) / whole : 0;
      const double first = length(258), last = own_.memory.q[259] != 0 ? length(259) : first;
      rapid(reached + first + (last - first) * part);
    }
    const double to = step > 0 ? std::max(bottom_, reached - step) : bottom_;
    double at = reached;
    while (length(257) > 0 && at - length(257) > to + tol::same_point && steps.size() < most_drilling_steps) {
      at -= length(257);
      feed(at, feed_of(206));
      feed(at + length(256), feed_of(206));
    }
    feed(to, feed_of(206));
    reached = to;
    step = std::max(step - length(212), std::max(length(205), q(212) > 0 ? 0.001 : step));
  }
  dwell(q(211));
  if (q(208) > 0) out(clearance_, feed_of(208), feed_of(206));
  else rapid(clearance_);
  leave();
}

/// 202: boring; the tool leaves the wall by 0.2 mm in the direction of Q214 (spec/heidenhain 12.3).
void CycleMaker::bore() {
  rapid(clearance_);
  feed(bottom_, feed_of(206));
  dwell(q(211));
  const Vec2 centre = at_;
  constexpr Vec2 ways[] = {{0, 0}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  const auto way = static_cast<std::size_t>(std::clamp(q(214), 0.0, 4.0));
  const SpindleDir before = m_.modal.spindle;
  if (way != 0) {
    spindle(SpindleDir::position, q(336));
    constexpr double clear = 0.2;
    in_plane(centre + clear * ways[way]);
    steps.back().kind = CycleStep::Kind::feed;
    steps.back().value = feed_of(206);  // INFERRED
  }
  out(clearance_, feed_of(208), feed_of(206));
  if (way != 0) in_plane(centre);
  if (way != 0) spindle(before);
  leave();
}

/// 208: a helix of pitch Q334 to the depth, and one full circle there (spec/heidenhain 12.6).
void CycleMaker::mill_bore() {
  const double tool = own_.tool_radius(m_), radius = length(335) / 2 - tool;
  const Vec2 centre = at_;
  rapid(clearance_);
  if (!(radius > tol::same_point)) {
    feed(bottom_, feed_of(206));
    dwell(q(211));
    rapid(clearance_);
    return leave();
  }
  const Vec2 wall = centre + Vec2{radius, 0};
  const auto arc = [&](Vec2 to, Vec2 middle, double turns, double down) {
    in_plane(to);
    CycleStep& step = steps.back();
    step.kind = CycleStep::Kind::arc;
    step.centre = middle;
    step.turns = turns;
    step.value = feed_of(206);
    step.clockwise = q(351) < 0;
    step.named |= AxisMask{1} << plane_.normal;
    step.to[plane_.normal] = down;
  };
  arc(wall, centre + Vec2{radius / 2, 0}, 0.5, clearance_);
  const double pitch = length(334), way = clearance_ - bottom_;
  const double turns = pitch > 0 ? std::ceil(way / pitch - 1e-9) : 1;
  arc(wall, centre, std::clamp(turns, 1.0, 10'000.0), bottom_);
  arc(wall, centre, 1, bottom_);
  arc(centre, centre + Vec2{radius / 2, 0}, 0.5, bottom_);
  rapid(clearance_);
  leave();
}

/// 241: in at Q253 with the speed of entry, drilled at its own speed with coolant, out at Q208 (spec/heidenhain 12.4).
void CycleMaker::single_lip() {
  const double start = surface_ - std::fabs(length(379));
  const auto turn = [&](std::size_t speed) {
    if (!own_.memory.given(speed) || !(q(speed) > 0)) return;
    constexpr double cw = 3, ccw = 4;
    spindle(q(426) == ccw ? SpindleDir::ccw : q(426) == cw || speed == 428 ? SpindleDir::cw : SpindleDir::stop);
    steps.back().value = q(speed);
  };
  const auto coolant = [&](std::size_t code) {
    if (!own_.memory.given(code) || !(q(code) > 0)) return;
    steps.emplace_back().kind = CycleStep::Kind::coolant;
    steps.back().value = std::round(q(code));
  };
  rapid(clearance_);
  turn(427);
  if (q(379) != 0) feed(start + length(200), feed_of(253));
  turn(428);
  coolant(429);
  feed(bottom_, feed_of(206));
  dwell(q(211));
  turn(427);
  out(clearance_, feed_of(208), feed_of(206));
  coolant(430);
  leave();
}

/// 1: pecking from the present height, called at the set-up clearance (spec/heidenhain 12.8).
void CycleMaker::old_peck() {
  const double start = m_.position.programmed[plane_.normal];
  const double surface = start - std::fabs(old(1)) * unit_, bottom = surface - std::fabs(old(2)) * unit_, step = std::fabs(old(3)) * unit_;
  const double depth = surface - bottom;
  const double advance = depth < 30 ? 0.6 : std::min(depth / 50, 7.0);
  double reached = surface;
  while (reached > bottom + tol::same_point && steps.size() < most_drilling_steps) {
    if (reached < surface) {
      rapid(start);
      rapid(reached + advance);
    }
    reached = step > 0 ? std::max(bottom, reached - step) : bottom;
    feed(reached, old(5) * unit_);
  }
  dwell(old(4));
  rapid(start);
}

Status CycleMaker::depth_allowed() const {
  if (q(201) > 0) return fail(alarm(AlarmId::value_out_of_range, where_, "Q201", q(201)));
  return {};
}

// NOLINTNEXTLINE(readability-function-size): one row for each cycle
Status CycleMaker::at_point() {
  const int cycle = own_.memory.cycle;
  const bool is_new = cycle >= 200;
  if (is_new) {
    const bool has_depth = cycle != 204 && !(cycle >= 230 && cycle <= 232);
    if (has_depth) KADR_TRY(depth_allowed());
    levels(length(203) + raised_, length(200), length(201));
    second_ = surface_ + length(204);
    if (q(201) == 0 && cycle != 240 && has_depth) return {};
  }
  switch (cycle) {
    case 1: old_peck(); return {};
    case 2:
    case 17:
    case 18: {
      const double start = m_.position.programmed[plane_.normal];
      const double bottom = start - (std::fabs(old(1)) + std::fabs(old(2))) * unit_;
      const double pitch = cycle == 2 ? 0 : old(3) * unit_;
      const SpindleDir turning = m_.modal.spindle;
      const SpindleDir back = turning == SpindleDir::ccw ? SpindleDir::cw : SpindleDir::ccw;
      if (cycle == 2) {
        feed(bottom, old(4) * unit_);
        spindle(back);
        dwell(old(3));
        feed(start, old(4) * unit_);
      } else {
        tap(bottom, pitch);
        spindle(back);
        tap(start, pitch);
      }
      spindle(turning);
      return {};
    }
    case 200: drill(); return {};
    case 201:
      rapid(clearance_);
      feed(bottom_, feed_of(206));
      dwell(q(211));
      out(clearance_, feed_of(208), feed_of(206));
      leave();
      return {};
    case 202: bore(); return {};
    case 203: universal(); return {};
    case 205: peck(); return {};
    case 206:
    case 207:
    case 209: {
      const bool rigid = cycle != 206;
      const double pitch = length(239), lead = rigid ? pitch * m_.modal.rpm : 0;
      const SpindleDir turning = rigid ? (pitch < 0 ? SpindleDir::ccw : SpindleDir::cw) : m_.modal.spindle;
      const SpindleDir back = turning == SpindleDir::ccw ? SpindleDir::cw : SpindleDir::ccw;
      if (rigid && !(std::fabs(lead) > 0)) return fail(alarm(AlarmId::speed_missing, where_));
      rapid(clearance_);
      double reached = surface_;
      const double step = cycle == 209 ? length(257) : 0;
      while (step > 0 && reached - step > bottom_ + tol::same_point && steps.size() < most_drilling_steps) {
        reached -= step;
        tap(reached, pitch);
        tap(q(256) > 0 ? reached + length(256) : clearance_, pitch);
      }
      if (rigid) tap(bottom_, pitch);
      else feed(bottom_, feed_of(206));
      spindle(back);
      dwell(q(211) * (cycle == 206 ? 1 : 0));
      if (rigid) tap(clearance_, pitch);
      else feed(clearance_, feed_of(206));
      spindle(m_.modal.spindle);
      leave();
      return {};
    }
    case 208: mill_bore(); return {};
    case 240: {
      const auto& offsets = m_.tables.offsets;
      double depth = length(201);
      if (q(343) == 1) {
        const double point = m_.modal.tool < offsets.size() ? 90.0 : 90.0;  // INFERRED: T-ANGLE of a centring tool
        const SinCos half = sincos_deg(point / 2);
        depth = -std::fabs(length(344)) / 2 * half.cos / half.sin;
      }
      bottom_ = surface_ + depth;
      rapid(clearance_);
      feed(bottom_, feed_of(206));
      dwell(q(211));
      rapid(clearance_);
      leave();
      return {};
    }
    case 241: single_lip(); return {};
    default: return AreaMaker(m_, own_, where_, at_, steps, raised_).run(cycle);
  }
}

Status CycleMaker::at_point(Vec2 point, bool at_clearance) {
  if (!at_clearance && second_ > clearance_) rapid(second_);
  in_plane(point);
  if (steps.size() > most_drilling_steps) return fail(alarm(AlarmId::cycle_endless, where_));
  return at_point();
}

}  // namespace kadr::heidenhain
