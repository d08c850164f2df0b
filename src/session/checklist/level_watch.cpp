// LevelWatch: finds implausible heights, far coordinates and changes of the unit. It is used by session/checklist and tested by
// tests/checklist.py.

#include "session/checklist/level_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace kadr {
namespace {

constexpr double level = 0.01;  // mm; heights that differ by less count as equal
constexpr std::size_t max_drilled = 1000;
constexpr double micrometre = 1000;  // number of micrometres per mm

bool turns(const Step& step, const Motion& motion) {
  for (std::size_t axis = 0; axis < step.roles.count; ++axis)
    if (step.roles.is_rotary(axis) && motion.to[axis] != 0) return true;
  return step.from.turn != nullptr || step.from.space != nullptr;
}

/// True if the part turns: the channel has no Y, or X is a diameter. Such a tool goes into the part from the side.
bool is_lathe(const Step& step, const Motion& motion) { return step.roles.xyz[1] < 0 || motion.diameters != 0; }

}  // namespace

/// Records the coordinates of the end of a motion. finish() reports a coordinate as far from all others if only one block has it and its
/// distance from the others is many times their range.
void LevelWatch::take_point(const Ends& ends, const Origin& origin) {
  const std::array values{ends.to.x, ends.to.y, ends.to.z}, came_from{ends.from.x, ends.from.y, ends.from.z};
  for (std::size_t i = 0; i < values.size(); ++i) {
    Span& span = spans_[i];
    const double v = values[i];
    // the motion does not move this axis, so its coordinate comes from an earlier block and has been counted there
    if (std::fabs(v - came_from[i]) < level) continue;
    const auto take = [&](std::array<double, 2>& best, std::array<Origin, 2>& where, double sign) {
      if (sign * v > sign * best[0]) {
        if (where[0].line != origin.line || best[0] * sign <= -1e299) best[1] = best[0], where[1] = where[0];
        best[0] = v, where[0] = origin;
      } else if (sign * v > sign * best[1] && where[0].line != origin.line) {
        best[1] = v, where[1] = origin;
      }
    };
    take(span.most, span.at_most, 1);
    take(span.least, span.at_least, -1);
  }
}

void LevelWatch::take_motion(const Step& step, const Motion& motion, Advices& to) {
  const Origin& origin = step.action.origin;
  const Ends ends(step.roles, step.from, motion);
  turned_ = turned_ || turns(step, motion) || is_lathe(step, motion);
  if (motion.system != system_) system_ = motion.system, lowest_ = 1e300, approach_ = -1e300;
  if (motion.end_reference != EndReference::by_work || motion.kind == MotionKind::home) {
    in_cut_.reset();
    z_by_machine_ = z_by_machine_ || (motion.named >> std::size_t(std::max(step.roles.xyz[2], 0)) & 1U) != 0;
    return;
  }
  if (inch_ && *inch_ != motion.inch) to.add(AlarmId::units_changed, origin, 0, motion.inch ? "G20" : "G21");
  inch_ = motion.inch;
  const bool from_machine = z_by_machine_;
  if (ends.to.z != ends.from.z) z_by_machine_ = false;
  if (plunge_ && is_cut(motion) && ends.sideways() && std::fabs(ends.from.z - plunge_->z) < level &&
      std::fabs(ends.to.z - plunge_->z) < level)
    // The tool moved down in a rapid and now moves sideways at feed at the same height. So the rapid itself has entered the material.
    if (!is_drilled(*plunge_)) note_low(*plunge_);
  plunge_.reset();
  // The tool cuts directly after a sideways rapid at a low Z. So the rapid moved at the height of the material.
  if (sideways_ && is_cut(motion)) note_low(*sideways_), sideways_.reset();
  if (motion.of_cycle && to_hole_ && to_hole_->second.number == origin.number) take_point(to_hole_->first, origin);
  to_hole_.reset();
  if (motion.kind == MotionKind::rapid && ends.sideways()) {
    if (motion.of_cycle) take_point(ends, origin);
    // A canned cycle may start in the block of the rapid. In that case the end of the rapid is the position of a hole.
    else to_hole_.emplace(ends, origin);
  }
  if (motion.of_cycle && is_cut(motion) && ends.down() && drilled_.size() < max_drilled) drilled_.push_back(ends.to);
  if (is_cut(motion)) {
    if (ends.sideways() || motion.of_cycle) {
      cuts_ = true, ++cuts_made_;
      lowest_ = std::min(lowest_, std::min(ends.from.z, ends.to.z));
      take_point(ends, origin);
    }
    if (!motion.of_cycle && ends.down()) lowest_ = std::min(lowest_, ends.to.z);
    if (!motion.of_cycle && ends.down() && !ends.sideways() && ends.to.z < -level) ++feeds_down_;
  } else if (motion.kind == MotionKind::rapid && !motion.of_cycle && !turned_) {
    if (ends.down() && !ends.sideways()) {
      if (ends.to.z >= 0 && heights_.size() < max_drilled) heights_.insert(std::llround(ends.to.z * micrometre));
      if (ends.to.z < -level && below_++ == 0) only_below_ = Low{origin, AlarmId::rapid_below_zero, ends.to.x, ends.to.y, ends.to.z};
    }
    const bool below = ends.to.z < -level && (from_machine || ends.from.z < -level || ends.down());
    if (below && ends.down() && !ends.sideways() && ends.to.z < lowest_ - level)
      plunge_ = Low{origin, AlarmId::rapid_below_zero, ends.to.x, ends.to.y, ends.to.z};
    constexpr double least_travel = 2;  // mm; a sideways rapid directly after a cut is ignored if it is shorter than this
    const bool straight_from_cut = was_cut_ && std::fabs(ends.to.z - ends.from.z) < level &&
                                   std::hypot(ends.to.x - ends.from.x, ends.to.y - ends.from.y) > least_travel;
    if (ends.sideways()) sideways_.reset();
    if (ends.sideways() && straight_from_cut && ends.to.z < -level && approach_ > ends.to.z + level)
      sideways_ = Low{origin, AlarmId::rapid_sideways_low, (ends.from.x + ends.to.x) / 2, (ends.from.y + ends.to.y) / 2, ends.to.z};
  }
  if (motion.kind == MotionKind::rapid && ends.to.z != ends.from.z) approach_ = std::max(approach_, ends.to.z);
  was_cut_ = is_cut(motion) && !motion.of_cycle;
  if (was_cut_ && ends.to.z <= ends.from.z && ends.to.z < approach_ - level) in_cut_ = origin;
  else in_cut_.reset();
  z_ = ends.to.z;
}

void LevelWatch::take_change(const Origin& origin, Advices& to) {
  if (cuts_ && !z_by_machine_ && !turned_ && approach_ > -1e299 && z_ < approach_ / 2)
    to.add(AlarmId::tool_change_low, origin, 0, z_, approach_);
  cuts_ = false;
  approach_ = -1e300;
  sideways_.reset();
}

void LevelWatch::take(const Step& step, Advices& to) {
  if (const Motion* const motion = step.motion()) take_motion(step, *motion, to);
  else if (const auto* const change = std::get_if<ToolChange>(&step.action.what); change != nullptr && !change->there)
    take_change(step.action.origin, to);
}

/// True if a canned cycle has drilled a hole at the position where the rapid `low` ends, at least as deep as the end of the rapid.
bool LevelWatch::is_drilled(const Low& low) const {
  constexpr double near = 1;  // mm; greatest distance at which two positions count as the same
  return std::any_of(drilled_.begin(), drilled_.end(),
                     [&](const Vec3& hole) { return std::hypot(hole.x - low.x, hole.y - low.y) < near && hole.z < low.z + near; });
}

void LevelWatch::judge_lows(Advices& to) const {
  // Greatest number of findings of one type that are reported. If there are more, the low rapids are probably intended, since a CAM system
  // knows where the material is already removed.
  constexpr std::ptrdiff_t most = 2;
  const auto like = [this](AlarmId id) { return std::count_if(lows_.begin(), lows_.end(), [id](const Low& low) { return low.id == id; }); };
  for (const Low& low : lows_) {
    const bool plunges = low.id == AlarmId::rapid_below_zero;
    // Rapids below the part's zero are reported only if some motion enters the material at feed. Without such a motion the rapids may go
    // through a hole or outside the part. `border`: least distance between a reported rapid and the border of the cut region, inwards, mm.
    // A contour starts at the border, and a rapid along the border is outside the part.
    const double border = plunges ? -0.01 : 0.5;
    const auto inside = [border](const Span& s, double v) { return v > s.least[0] + border && v < s.most[0] - border; };
    if (like(low.id) <= most && inside(spans_[0], low.x) && inside(spans_[1], low.y) && (!plunges || feeds_down_ > 0))
      to.add(low.id, low.origin, plunges ? 'Z' : '\0', low.z);
  }
  if (only_below_ && below_ == 1 &&
      // another rapid ends as far above the part's zero as this one ends below, so the minus sign of this Z is probably a mistake
      heights_.contains(std::llround(-only_below_->z * micrometre)))
    to.add(AlarmId::rapid_below_zero, only_below_->origin, 'Z', only_below_->z);
}

void LevelWatch::finish(Advices& to) {
  judge_lows(to);
  constexpr std::size_t enough = 4;
  if (cuts_made_ < enough) return;
  constexpr std::array<const char*, 3> names{"X", "Y", "Z"};
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    const Span& s = spans_[i];
    const double low = s.least[1], high = s.most[1];
    const double others = high - low;
    if (!(others >= 0 && others < 1e299)) continue;
    const std::string range = fmt::format("{:.4g} … {:.4g}", low, high);
    // mm; least distance at which a coordinate is reported if all other coordinates of its axis are equal
    constexpr double unknown = 250;
    // A coordinate is reported if its distance from the other coordinates of its axis exceeds both `least` mm and `many` times their range.
    const double many = i == 2 ? 10 : 5, least = i == 2 ? 50 : 20;
    const auto is_far = [&](double by) { return by > many * others && by > (others > 0 ? least : unknown); };
    if (is_far(s.most[0] - high) && !is_far(low - s.least[0]))
      to.add(AlarmId::coordinate_far, s.at_most[0], names[i][0], names[i], s.most[0], std::string_view(range));
    if (is_far(low - s.least[0]) && !is_far(s.most[0] - high))
      to.add(AlarmId::coordinate_far, s.at_least[0], names[i][0], names[i], s.least[0], std::string_view(range));
  }
}

}  // namespace kadr
