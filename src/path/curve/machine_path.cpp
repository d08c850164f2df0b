// MachinePath is the path of one motion in machine coordinates. The bounding boxes of its pieces are used to check the axes against limits
// and forbidden areas. Used by machine/zone_box and motion/least_time/axis_motion; tested by tests/path/machine_path_test.cpp.

#include "path/curve/machine_path.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/extremes.h"

namespace kadr {
namespace {

constexpr int max_chords_of_motion = 20'000;  // the greatest number of chords for one motion

/// Returns true if a rotary axis moves under tool centre point control. In this case the axes do not move along a straight line.
bool turns_with_tip_control(const ToolPosition& from, const Motion& motion) {
  if (!controls_tip(from, motion)) return false;
  if (motion.detail && motion.detail->tip_path) return true;
  for (AxisMask left = from.space->rotary_axes(); left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    if (motion.to[axis] != from.work[axis] || (motion.detail && (motion.detail->rolled >> axis & 1U) != 0)) return true;
  }
  return false;
}

}  // namespace

MachinePath::MachinePath(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve)
    : roles_(roles),
      from_(from),
      motion_(motion),
      curve_(curve),
      end_(motion.machine),
      bends_(turns_with_tip_control(from, motion)),
      straight_(curve.straight() && !bends_) {
  for (std::size_t i = 0; i < roles.count; ++i)
    if (rolls_over(i)) end_[i] = from.machine[i] + motion.detail->travel[i];
}

Axes MachinePath::at(double part) const {
  if (part <= 0) return start();
  if (part >= 1) return end_;
  if (!straight()) return machine_along(roles_, from_, motion_, curve_.at(part), part);
  Axes point = start();
  for (std::size_t i = 0; i < roles_.count; ++i) point[i] += part * (end_[i] - point[i]);
  return point;
}

Extents MachinePath::tip_control_extents(double from, double to) const {
  Extents box{at(from), at(to)};
  for (std::size_t i = 0; i < roles_.count; ++i) {
    const Range range = range_of([&](double part) { return at(from + part * (to - from))[i]; }, samples_with_tip_control());
    box.least[i] = range.least;
    box.most[i] = range.most;
  }
  return box;
}

/// Returns an upper bound, mm, of the distance between the axes' path in a straight motion and the chord of this path. A point travels the
/// length L while it is rotated by the angle ω (rad) about axes that are at most the distance R away. The second derivative of its path
/// over the motion is at most ω²R + 2ωL, and the distance from the chord is at most an eighth of this value.
double MachinePath::most_off_chord() const {
  double turn = 0;
  for (AxisMask left = from_.space->rotary_axes(); left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    turn += std::fabs(end_[axis] - from_.machine[axis]) * rad_per_deg;
  }
  const double path_length = curve_.length(),
               arm = path_length + std::max(from_.space->arm(from_.machine), from_.space->arm(motion_.machine));
  return (turn * turn * arm + 2 * turn * path_length) / 8;
}

Extents MachinePath::rough_extents() const {
  if (!tip_moves_straight()) return extents(0, 1);
  Extents box;
  const AxisMask rotary = from_.space->rotary_axes();
  const double off = most_off_chord();
  for (std::size_t i = 0; i < roles_.count; ++i) {
    std::tie(box.least[i], box.most[i]) = std::minmax({from_.machine[i], end_[i]});
    if ((rotary >> i & 1U) == 0) box.least[i] -= off, box.most[i] += off;
  }
  return box;
}

/// Returns the number of samples along the motion under tool centre point control. While a rotary axis turns by a quarter revolution, the
/// position of a linear axis has about one extreme. The samples must be so close that at most about one extreme lies between two
/// neighbouring samples.
int MachinePath::samples_with_tip_control() const {
  constexpr double between = 15;  // greatest rotation of a rotary axis between two samples of the path, degrees
  double rotation = 0;
  for (AxisMask left = from_.space->rotary_axes(); left != 0; left &= left - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(left));
    rotation = std::max(rotation, std::fabs(end_[axis] - from_.machine[axis]));
  }
  constexpr int most = 1000;
  const int least = motion_.detail && motion_.detail->tip_path ? 8 : 2;
  return std::clamp(static_cast<int>(rotation / between) + least, curve_.samples(), std::max(curve_.samples(), most));
}

/// Where rotary axes curve the path, the deviation from the chord is measured in the middle of a few pieces. The number of pieces follows
/// from this deviation, which is proportional to h², where h is the length of a piece. The pieces are chosen for half of the permitted
/// deviation, as a reserve.
int MachinePath::pieces(double chord) const {
  const int of_curve = curve_.pieces(chord);
  // A motion that deviates by less than this multiple of `chord` stays one piece, because it meets its neighbours at corners anyway.
  constexpr double few = 6;
  if (!bends_ || (tip_moves_straight() && most_off_chord() <= few * chord)) return of_curve;
  constexpr int looked_at = 8;
  double worst = 0;
  for (int i = 0; i < looked_at; ++i) {
    const Axes a = at(double(i) / looked_at), b = at(double(i + 1) / looked_at), middle = at((i + 0.5) / looked_at);
    double off = 0;
    for (std::size_t n = 0; n < roles_.count; ++n) {
      const double d = middle[n] - (a[n] + b[n]) / 2;
      off += d * d;
    }
    worst = std::max(worst, std::sqrt(off));
  }
  if (worst * looked_at * looked_at <= few * chord) return of_curve;
  const double aimed = chord / 2;
  const double needed = looked_at * std::sqrt(worst / aimed);
  return std::clamp(static_cast<int>(std::ceil(needed)), of_curve, std::max(of_curve, max_chords_of_motion));
}

Extents MachinePath::extents(double from, double to) const {
  if (straight()) {
    Extents box{at(from), at(to)};
    for (std::size_t i = 0; i < roles_.count; ++i)
      if (box.least[i] > box.most[i]) std::swap(box.least[i], box.most[i]);
    return box;
  }
  if (bends_ || (!straight_ && controls_tip())) return tip_control_extents(from, to);
  if (from <= 0 && to >= 1) return machine_extents(roles_, from_, motion_, curve_);
  const ToolPosition piece_from{curve_.at(from), at(from), from_.turn, from_.space};
  Motion piece = motion_;
  piece.to = curve_.at(to);
  piece.machine = at(to);
  piece.turns = motion_.turns * (to - from);
  if (motion_.detail) {
    auto detail = std::make_shared<MotionDetail>(*motion_.detail);
    for (double& travel : detail->travel) travel *= to - from;
    detail->flat_from = curve_.flat(from);
    detail->flat_to = curve_.flat(to);
    const SplinePart whole = detail->spline;
    detail->spline.from = whole.from + from * (whole.to - whole.from);
    detail->spline.to = whole.from + to * (whole.to - whole.from);
    piece.detail = std::move(detail);
  }
  return machine_extents(roles_, piece_from, piece);
}

}  // namespace kadr
