// Writes arcs with different radii at start and end as short lines, for controls that do not allow such arcs; the rise of a helix. Used by
// convert/flat/flat_program; tested by tests/convert_real.py.

#include <algorithm>
#include <cmath>

#include "convert/flat/flat_program.h"
#include "out/program/words.h"

namespace kadr {
namespace {

constexpr int max_pieces = 20'000;
// Greatest chord error, in increments of the control. The rounding error of the words, half an increment of each axis, is added to it.
constexpr double chord_of_increment = 1.0 / 8;

double increment_of(const ControlDef& def, const std::string& axis) {
  const Words form(def, axis.front());
  return form.known() ? form.increment() : 0;
}

}  // namespace

/// Returns the travel of an axis to the position `to`, counted from the rounded words before, in the unit of the axis.
double FlatProgram::rise_of(std::size_t axis, const Axes& to) const {
  const double zero = base()[axis];
  return std::fabs(relative_ ? rounded(axis, to[axis] - at_[axis]) : rounded(axis, to[axis] - zero) - rounded(axis, at_[axis] - zero));
}

bool FlatProgram::is_spiral(const Arms& arms) const {
  const ControlDef& def = blocks_.def();
  // true if the control has a parameter for the difference of radii; its default 0 switches the check off, so arcs with different radii are
  // allowed
  const bool is_free = def.has_parameter("arc_difference");
  return !is_free && std::fabs(arms.end - arms.begin) > def.behaviour.arc_radius_difference;
}

/// Writes the arc as short lines. The radius grows linearly with the angle, and all other axes move in proportion to the angle.
Status FlatProgram::spiral(const Motion& motion, Vec2 centre, const Arms& arms) {
  const std::size_t first = motion.first, second = motion.second;
  const double increment = std::max(increment_of(blocks_.def(), axes_[first]), increment_of(blocks_.def(), axes_[second]));
  const double angle = 2 * pi * motion.turns, chord = increment * chord_of_increment;
  const double pieces = std::ceil(std::fabs(angle) / std::sqrt(8 * chord / std::max(arms.begin, arms.end)));
  const bool is_led = motion.side != 0 && is_by_codes();   // true if the target control's cutter compensation is active
  const bool is_whole = motion.unit == FeedUnit::per_min;  // true if the feed is an inverse time for the arc as a whole
  if (is_led || is_whole || !(pieces >= 1 && pieces <= max_pieces)) return fail(alarm(AlarmId::function_has_no_code, {}, "arc_cw"));
  const Axes from = at_;
  const double begin = std::atan2(from[second] - centre.y, from[first] - centre.x), sense = motion.kind == MotionKind::arc_ccw ? 1 : -1;
  Motion piece = motion;
  for (int i = 1; i <= int(pieces); ++i) {
    const double part = i / pieces, at = begin + sense * angle * part, radius = arms.begin + (arms.end - arms.begin) * part;
    for (std::size_t a = 0; a < max_axes; ++a) piece.machine[a] = from[a] + (motion.machine[a] - from[a]) * part;
    if (i < int(pieces)) piece.machine[first] = centre.x + radius * std::cos(at), piece.machine[second] = centre.y + radius * std::sin(at);
    KADR_TRY(end_of_motion(motion.exact && i == int(pieces)));
    KADR_TRY(straight(Function::linear, piece));
    if (i < int(pieces)) KADR_TRY(blocks_.end());
    at_ = piece.machine;
  }
  return {};
}

}  // namespace kadr
