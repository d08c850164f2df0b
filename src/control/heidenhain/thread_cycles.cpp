// Thread milling 262 to 265, 267, and back boring 204 (spec/heidenhain 12.4, 12.11). The manual does not state the geometry of the
// approach: a half circle that rises by a quarter of the pitch. Used by control/heidenhain.

#include <algorithm>
#include <cmath>

#include "base/tolerance.h"
#include "control/heidenhain/area_cycles.h"

namespace kadr::heidenhain {

/// One run of the thread between two heights, with a half circle to its diameter and one back to the middle; outside (267) the half circles
/// lead from and to a point outside the thread.
///   radius  of the path of the tool's centre
void AreaMaker::thread_turns(MillPath& path, double radius, double from, double to) {
  const double pitch = std::fabs(length_of(239)), up = to > from ? 1 : -1;
  const double turns = std::fabs(to - from) / pitch;
  const bool outside = operation_ == 267;
  // The half circle of the approach has the sense of the thread inside, the opposite one outside.
  const double start = outside ? radius + 2 * radius_ : 0;
  const Vec2 near{radius, 0}, beside{start, 0}, middle{(start + radius) / 2, 0};
  path.move(beside, plunge_feed_);
  path.raise(from - up * pitch / 4, plunge_feed_);
  path.helix(near, from, middle, 0.5, outside ? !clockwise_ : clockwise_, given(512) && q(512) != 0 ? feed_of(512) : feed_);
  const double whole = std::floor(turns + 1e-9), part = turns - whole > 1e-9 ? turns - whole : 0;
  const Vec2 end = rotated(near, (clockwise_ ? -360 : 360) * part);
  path.helix(end, to, {}, turns, clockwise_, feed_);
  const Vec2 away = rotated(beside, (clockwise_ ? -360 : 360) * part), centre = rotated(middle, (clockwise_ ? -360 : 360) * part);
  path.helix(away, to + up * pitch / 4, centre, 0.5, outside ? !clockwise_ : clockwise_, feed_);
}

/// A countersink at the front: down to `depth`, a circle with the radius `offset`, and back to the middle (Q358, Q359).
void AreaMaker::countersink(MillPath& path, double depth, double offset, double feed) {
  path.move({0, 0}, plunge_feed_);
  path.raise(surface_ + depth, plunge_feed_);
  if (!(std::fabs(offset) > tol::same_point)) return;
  const double r = std::fabs(offset);
  path.arc({r, 0}, {r / 2, 0}, 0.5, false, feed);
  path.arc({r, 0}, {0, 0}, 1, false, feed);
  path.arc({0, 0}, {r / 2, 0}, 0.5, false, feed);
}

/// 264: the hole, with infeeds Q202 and chip breaking Q257, Q256.
Status AreaMaker::drill_first(MillPath& path) {
  const double hole = surface_ + length_of(356), step = std::fabs(length_of(202));
  double reached = surface_;
  while (reached > hole + tol::same_point) {
    if (path.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
    if (reached < surface_) {
      path.raise(clearance_);
      path.raise(reached + std::max(0.0, length_of(258)));
    }
    const double to = step > 0 ? std::max(hole, reached - step) : hole, piece = length_of(257);
    for (double at = reached - piece; piece > 0 && at > to + tol::same_point; at -= piece) {
      path.raise(at, feed_of(206));
      path.raise(at + length_of(256), feed_of(206));
      if (path.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
    }
    path.raise(to, feed_of(206));
    reached = to;
  }
  path.raise(clearance_);
  return {};
}

Status AreaMaker::thread(int cycle) {
  const auto cutter = own_.cutter_radius(m_, where_);
  if (!cutter) return fail(cutter.error());
  radius_ = *cutter;
  take_levels();
  const double pitch = length_of(239);
  if (pitch == 0) return fail(alarm(AlarmId::value_out_of_range, where_, "Q239", pitch));
  operation_ = cycle;
  feed_ = feed_of(207);
  plunge_feed_ = given(253) && q(253) != 0 ? feed_of(253) : -1;
  if (feed_ == 0) KADR_TRY(needs_feed());
  const bool outside = cycle == 267;
  const double radius = length_of(335) / 2 + (outside ? radius_ : -radius_);
  if (!(radius > tol::same_point)) return fail(alarm(AlarmId::pocket_tool_large, where_, 2 * radius_, length_of(335), length_of(335)));
  // Climb milling inside is counter-clockwise; a right-hand thread rises then, a left-hand one goes down (spec/heidenhain 5.2).
  const bool climb = cycle == 265 || !given(351) || q(351) >= 0;
  clockwise_ = outside == climb;
  const bool rises = cycle != 265 && (pitch > 0) == !clockwise_;
  if (cycle == 265) clockwise_ = pitch > 0;
  MillPath path = new_path();
  path.set_frame(at_, 0);
  path.raise(clearance_);
  const double sinking = given(254) && q(254) != 0 ? feed_of(254) : feed_;
  if (cycle == 264) KADR_TRY(drill_first(path));
  if (cycle == 263 && length_of(356) != 0) countersink(path, length_of(356), given(359) ? length_of(359) : 0, sinking);
  const bool front = given(358) && q(358) != 0;
  const bool after = cycle == 265 && given(360) && q(360) == 1;
  if (front && cycle != 263 && !after) countersink(path, length_of(358), length_of(359), sinking);
  path.raise(clearance_);
  if (outside) path.move({radius + 2 * radius_, 0});
  const double step = std::fabs(pitch), along = given(355) ? std::round(q(355)) : 0;
  if (cycle == 262 || cycle == 267) {
    if (along == 1) {
      thread_turns(path, radius, rises ? bottom_ : surface_, rises ? surface_ : bottom_);
    } else {
      const double part = along > 1 ? along * step : surface_ - bottom_;
      for (double low = bottom_; low < surface_ - tol::same_point; low += part) {
        if (path.size() > most_steps) return fail(alarm(AlarmId::cycle_endless, where_));
        thread_turns(path, radius, rises ? low : low + step, rises ? low + step : low);
        if (along <= 1) break;
      }
    }
  } else if (cycle == 265) {
    thread_turns(path, radius, surface_, bottom_);
  } else {
    thread_turns(path, radius, rises ? bottom_ : bottom_ + step, rises ? bottom_ + step : bottom_);
  }
  if (!outside) path.move({0, 0}, feed_);
  path.raise(clearance_);
  if (front && after) {
    countersink(path, length_of(358), length_of(359), sinking);
    path.raise(clearance_);
  }
  leave(path);
  if (outside) path.move({0, 0});
  return {};
}

/// 204: the tool passes the bore off-centre, and cuts upwards from below (spec/heidenhain 12.4).
Status AreaMaker::back_boring() {
  take_levels();
  const int way = static_cast<int>(q(214));
  if (way < 1 || way > 4) return fail(alarm(AlarmId::value_out_of_range, where_, "Q214", q(214)));
  constexpr Vec2 ways[] = {{0, 0}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
  const Vec2 aside = length_of(251) * ways[way];
  const double lower = surface_ - std::fabs(length_of(250)), edge = length_of(252), place = feed_of(253);
  const double below = lower - length_of(200) - edge, top = lower + std::fabs(length_of(249)) - edge;
  if (place == 0 || q(254) == 0) KADR_TRY(needs_feed());
  const SpindleDir before = m_.modal.spindle;
  MillPath path = new_path();
  path.set_frame(at_, 0);
  path.raise(clearance_);
  spindle(SpindleDir::position, q(336));
  path.move(aside, place);
  path.raise(below, place);
  path.move({0, 0}, place);
  spindle(before);
  path.raise(top, feed_of(254));
  dwell(q(255));
  path.raise(below, place);
  spindle(SpindleDir::position, q(336));
  path.move(aside, place);
  path.raise(clearance_, place);
  path.move({0, 0}, place);
  spindle(before);
  leave(path);
  return {};
}

}  // namespace kadr::heidenhain
