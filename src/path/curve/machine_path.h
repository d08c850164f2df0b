#pragma once
// MachinePath: the way of one motion in machine coordinates, and the bounding boxes of its pieces: what a guard of the axes
// looks at. A piece of an arc, a spiral, a polar or cylinder motion is such a motion again, so its box is as exact as the whole's.

#include <algorithm>
#include <optional>

#include "action/step.h"
#include "path/curve/machine_extents.h"

namespace kadr {

/// A view of a motion: what it is made of must outlive it.
class MachinePath {
 public:
  ///   curve  of the motion from there
  MachinePath(const AxisRoles& roles, const ToolPosition& from, const Motion& motion, const Curve& curve);
  /// Of a step that is a motion.
  explicit MachinePath(const Step& step) : MachinePath(step.roles, step.from, *step.motion(), step.curve()) {}

  /// A straight line of all axes, from start() to end().
  bool straight() const { return straight_; }
  /// The tip is led, and the axes' speeds are not in proportion to its own.
  bool bends() const { return bends_; }
  const Axes& start() const { return from_.machine; }

  /// Where the axes stand after it. Axes that roll over count on beyond their turn.
  const Axes& end() const { return end_; }
  bool rolls_over(std::size_t axis) const { return motion_.detail && (motion_.detail->rolled >> axis & 1U) != 0; }

  Axes at(double part) const;
  bool leads_tip() const { return kadr::leads_tip(from_, motion_); }
  /// Where the tip is then in the part, where it is led.
  Vec3 tip(double part) const { return led_tip(roles_, from_, motion_, curve_.at(part), part); }

  /// Number of equal pieces whose chords stay within `chord` mm of the path, of the tool's tip too where that is led.
  int pieces(double chord) const;

  /// Bounding box of the piece between two parts. Exact for lines; else as machine_extents().
  Extents extents(double from, double to) const;

  /// The first part from which on the path may not be clear; nothing: it is clear all along.
  ///   clear  whether a piece with this bounding box is certainly clear; true of a box means true of every box inside it
  ///   law    at most `closeness` away from there, in every axis, the path is not clear
  template <class Clear>
  std::optional<double> first_not(const Clear& clear) const {
    return first_not(clear, 0, 1, most_halvings);
  }

  /// A box that is certainly as great as that of the whole, found at once.
  Extents rough_extents() const;

  static constexpr double closeness = 1e-7;  // mm, degrees: a tenth of tol::same_point

 private:
  Extents led_extents(double from, double to) const;
  int samples_led() const;
  /// The tip goes straight, the rotary axes evenly.
  bool plainly_led() const { return bends_ && curve_.straight() && !(motion_.detail && motion_.detail->tip_way); }
  double most_off_chord() const;

  static constexpr int most_halvings = 60;

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
