#pragma once
// MachinePath is the path of one motion in machine coordinates. The bounding boxes of its pieces are used to check the axis positions
// against limits and forbidden areas. A piece of an arc, spiral, polar or cylindrical motion is again a motion of the same type, so the
// bounding box of a piece is as exact as the box of the whole motion.

#include <algorithm>
#include <optional>

#include "action/step.h"
#include "path/curve/machine_extents.h"

namespace kadr {

/// The path of one motion. The objects that are passed to the constructor must outlive the MachinePath, because it keeps references to
/// them.
class MachinePath {
 public:
  ///   curve  the curve of the motion that starts at `from`
  MachinePath(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve);
  /// The path of a step, which must be a motion.
  explicit MachinePath(const Step& step) : MachinePath(step.roles, step.from, *step.motion(), step.curve()) {}

  /// True if all axes move along one straight line, from start() to end().
  bool straight() const { return straight_; }
  /// True if the motion is under tool centre point control and the axis speeds are not proportional to the speed of the tip.
  bool bends() const { return bends_; }
  const Axes& start() const { return from_.machine; }

  /// The axes' position after the motion. The position of an axis with rollover is not reduced to one revolution.
  const Axes& end() const { return end_; }
  bool rolls_over(std::size_t axis) const { return motion_.detail && (motion_.detail->rolled >> axis & 1U) != 0; }

  Axes at(double part) const;
  bool controls_tip() const { return kadr::controls_tip(from_, motion_); }
  /// Returns the position of the tool tip at the fraction `part`, 0 to 1, of a motion under tool centre point control.
  Vec3 tip(double part) const { return controlled_tip(roles_, from_, motion_, curve_.at(part), part); }

  /// Returns the number of equal pieces whose chords stay within `chord` mm of the path. Under tool centre point control the chords also
  /// stay within `chord` mm of the path of the tool tip.
  int pieces(double chord) const;

  /// Returns the bounding box of the path between two fractions, 0 to 1, of the motion. The box is exact for lines; otherwise it is as
  /// accurate as machine_extents().
  Extents extents(double from, double to) const;

  /// Returns the first position, 0 to 1, at which `clear` cannot confirm that the path is clear; nullopt if the whole path is clear.
  ///   clear  returns true if a piece of the path with this bounding box is certainly clear; if the result is true for a box, it must be
  ///          true for every box inside this box
  ///   law    within `closeness` of the returned position, in every axis, the path is not clear
  template <class Clear>
  std::optional<double> first_not(const Clear& clear) const {
    return first_not(clear, 0, 1, max_halvings);
  }

  /// Returns a box that certainly contains the whole path. The box is computed without sampling, so it may be larger than necessary.
  Extents rough_extents() const;

  static constexpr double closeness = 1e-7;  // accuracy of first_not() in mm or degrees: a tenth of tol::same_point

 private:
  Extents tip_control_extents(double from, double to) const;
  int samples_with_tip_control() const;
  /// True if the tip moves along a straight line and the rotary axes move evenly.
  bool tip_moves_straight() const { return bends_ && curve_.straight() && !(motion_.detail && motion_.detail->tip_path); }
  double most_off_chord() const;

  static constexpr int max_halvings = 60;

  template <class Clear>
  std::optional<double> first_not(const Clear& clear, double from, double to, int halvings) const {
    const Extents box = extents(from, to);
    if (clear(box)) return std::nullopt;
    double widest = 0;
    for (std::size_t i = 0; i < roles_.count; ++i) widest = std::max(widest, box.most[i] - box.least[i]);
    const double middle = from + (to - from) / 2;
    if (widest <= closeness || halvings == 0 || middle <= from || middle >= to) return from;
    if (const auto found = first_not(clear, from, middle, halvings - 1)) return found;
    return first_not(clear, middle, to, halvings - 1);
  }

  const AxisRoles& roles_;
  const ToolPosition& from_;
  const Motion& motion_;
  const Curve& curve_;
  Axes end_;
  bool bends_, straight_;
};

}  // namespace kadr
