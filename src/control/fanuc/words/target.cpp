// Converts axis words to the programmed end point (spec/nct/05).

#include <bit>
#include <cmath>

#include "control/block_context.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/geometry/automatic_geometry.h"
#include "control/fanuc/words/coordinates.h"

namespace kadr::fanuc {
namespace {

/// Computes the end point of a block in G16 (polar coordinates): the word of the first plane axis is the radius, the word of the second
/// axis the angle (5.4).
void polar(const BlockContext& m, const Word* radius, const Word* angle, Axes& to, AxisMask& named) {
  // The function changes the modal state, because radius and angle of the block stay valid for later blocks.
  Modal& modal = const_cast<BlockContext&>(m).modal;
  const PlaneAxes& plane = modal.axes;
  const Vec2 here{m.position.programmed[plane.first], m.position.programmed[plane.second]};
  if (!modal.polar_angle_given) modal.polar_angle = angle_deg(here);
  if (!modal.polar_radius_given) {
    modal.polar_radius = length(here);
    modal.polar_radius_absolute = true;
  }
  if (radius != nullptr) {
    modal.polar_radius = coordinate(m, *radius, plane.first);
    modal.polar_radius_absolute = !is_increment(m, *radius);
    modal.polar_radius_given = true;
  }
  if (angle != nullptr) {
    modal.polar_angle = angle->value + (is_increment(m, *angle) ? modal.polar_angle : 0.0);
    modal.polar_angle_given = true;
  }
  const Vec2 pole = modal.polar_radius_absolute ? Vec2{} : here;
  const SinCos at = sincos_deg(modal.polar_angle);
  to[plane.first] = pole.x + modal.polar_radius * at.cos;
  to[plane.second] = pole.y + modal.polar_radius * at.sin;
  named |= 1u << plane.first | 1u << plane.second;
}

/// Returns the alarm for two words that position the same axis (such as X and the increment U); the location in the alarm is that of the
/// later word.
tl::unexpected<Alarm> twice(const BlockContext& m, std::size_t axis) {
  const Word* last = nullptr;
  for (std::uint32_t i = 0; i < m.block->word_count; ++i) {
    const Word& w = m.block->words[i];
    if (w.address != 0 && (m.letters.axes & letter_bit(w.address)) != 0 && m.def.address(w.address).axis == axis) last = &w;
  }
  return fail(alarm(AlarmId::address_twice, last->where, last->address));
}

}  // namespace

bool is_diameter(const BlockContext& m, std::size_t axis) { return (m.modal.diameter >> axis & 1u) != 0; }

double coordinate(const BlockContext& m, const Word& w, std::size_t axis) {
  // 4.5: in polar interpolation the word of the rotary axis is a length, as that axis stands for a virtual linear axis
  const bool is_virtual = m.modal.surface == PathSurface::polar && axis == m.modal.axes.second;
  const bool is_length = is_virtual || m.def.address(w.address).unit == WordUnit::length;
  const double v = w.value * (is_length ? m.unit_scale() : 1.0);
  return is_diameter(m, axis) ? v / 2 : v;
}

bool is_increment(const BlockContext& m, const Word& w) {
  if (fanuc_of(m).absolute_block) return false;
  return !m.modal.absolute || w.incremental || m.def.address(w.address).function == Function::increment_axis;
}

/// Returns the position `c` of an axis that rolls over, reduced to [0, period) degrees.
double rolled_position(double c, double period) {
  const double r = c - period * std::floor(c / period);
  return r < period ? r : 0;  // the result is 0 if rounding has raised the position to a full period
}

/// Returns the signed travel in degrees of a rotary axis that rolls over (5.6), from position c in [0, period) to the programmed value.
double roll_travel(const AxisSettings& axis, double c, double programmed, bool increment) {
  const double period = axis.period;
  if (increment) return axis.cuts_turns ? programmed - period * std::trunc(programmed / period) : programmed;
  if (axis.by_sign) {  // INFERRED: if both are set, parameter bit ABS (direction by sign) has priority over ASH (shorter direction)
    const double t = rolled_position(std::fabs(programmed), period);
    return programmed >= 0 ? rolled_position(t - c, period) : -rolled_position(c - t, period);
  }
  if (axis.shortest) {
    const double d = rolled_position(programmed - c, period);
    return d <= period / 2 ? d : d - period;
  }
  const double travel = programmed - c;
  return travel - period * std::trunc(travel / period);
}

namespace {

/// Positions the rotary axes in the shorter direction, as the programmed tool direction requires (25.14).
void take_directed(const BlockContext& m, Axes& to, AxisMask& named) {
  Fanuc& fanuc = fanuc_of(m);
  for (std::size_t axis = 0; axis < m.axis_count; ++axis) {
    if ((fanuc.by_direction >> axis & 1u) == 0) continue;
    named |= AxisMask{1} << axis;
    const AxisSettings& settings = fanuc.settings.axes[axis];
    to[axis] = fanuc.directed[axis] - m.frames.origin[axis];
    if (!settings.rolls) continue;
    fanuc.travel[axis] = to[axis] - m.position.programmed[axis];
    fanuc.rolled |= AxisMask{1} << axis;
    to[axis] = rolled_position(to[axis], settings.period);
  }
}

}  // namespace

Status target(const BlockContext& m, Axes& to, AxisMask& named) {
  to = m.position.programmed;
  named = 0;
  Fanuc& fanuc = fanuc_of(m);
  fanuc.rolled = 0;
  const PlaneAxes& plane = m.modal.axes;
  const bool is_polar = m.modal.polar_data && !fanuc.cartesian_block;
  const Word* radius = nullptr;
  const Word* angle = nullptr;
  // Each address occurs only once in a block, because blocks.cpp has checked the block.
  for (std::uint64_t left = m.block->letters & m.letters.axes; left != 0; left &= left - 1) {
    const Word& w = m.block->words[m.block->at[static_cast<std::size_t>(std::countr_zero(left))]];
    if (w.address == 0) continue;  // a drilling cycle has hidden this word temporarily by an address of 0
    const std::size_t axis = m.def.address(w.address).axis;
    const bool polar_word = is_polar && (axis == plane.first || axis == plane.second);
    if ((named >> axis & 1u) != 0 || (polar_word && (axis == plane.first ? radius : angle) != nullptr)) return twice(m, axis);
    if (polar_word) {
      (axis == plane.first ? radius : angle) = &w;
      continue;
    }
    // this rotary axis word replaces I, J or K of a tool direction; take_directed() sets the axis position
    if ((fanuc.by_direction >> axis & 1u) != 0) continue;
    const double v = coordinate(m, w, axis);
    const AxisSettings& settings = fanuc.settings.axes[axis];
    const bool increment = is_increment(m, w);
    named |= 1u << axis;
    if (settings.rolls && (m.def.rotary >> axis & 1u) != 0 && m.modal.surface == PathSurface::plane) {
      const double from = rolled_position(m.position.programmed[axis], settings.period);
      fanuc.travel[axis] = roll_travel(settings, from, v, increment);
      fanuc.rolled |= 1u << axis;
      to[axis] = rolled_position(from + fanuc.travel[axis], settings.period);
    } else {
      to[axis] = increment ? m.position.programmed[axis] + v : v;
    }
    if (!(std::fabs(to[axis]) <= farthest)) return fail(alarm(AlarmId::position_out_of_range, w.where, w.address, to[axis]));
  }
  if (radius != nullptr || angle != nullptr) polar(m, radius, angle, to, named);
  if (m.has(comma_angle)) KADR_TRY(end_by_angle(m, to, named));
  if (fanuc.by_direction != 0) take_directed(m, to, named);
  if (named != 0) named |= fanuc.taken_up;
  if ((named & fanuc.following) == 0) [[likely]]
    return {};
  return m.dialect->may_move(m, named);
}

}  // namespace kadr::fanuc
