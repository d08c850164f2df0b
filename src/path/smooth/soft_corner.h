#pragma once
// SoftCorner: the shape by which a corner of a path is rounded so that the third derivative of the path stays bounded.
//
// At a corner the direction of a path of straight pieces jumps by Δu: its second derivative is a pulse. The rounding spreads the pulse
// over [−w, w] (w: width of the rounding, s: distance from the corner) as Δu k(s), which moves the path by Δu g(s), with g″ = k. A pulse
// with negative parts lets the path deviate to the outside before and after the corner as far as it cuts the corner inside: for the same
// deviation the corner needs a third to a sixth of the jerk.
//
//   gentle corner   the speed is constant in the rounding: g‴ = ±c, with c constant
//   sharp corner    the speed falls towards the corner and rises after it, as on a machine whose axes stop and start one after
//                   the other with constant jerk: the shape is defined over time and mapped to the path; derived for a corner of 90°
//
// In both shapes the deviation at the corner equals the greatest deviation to the outside. The shapes were found as perfect splines
// (Karlin 1975); this is our own work.

#include <array>
#include <cstddef>

namespace kadr {

class SoftCorner {
 public:
  // greatest width of a rounding to either side, mm; wider roundings cost computing time and gain little below 12 m/min
  static constexpr double widest = 2;
  /// A time in the sharp corner's shape. The starting axis moves backwards at first; at this time it is as far in front of its start
  /// position as it was behind it at most: start(equal_swings) = −start(2 + √2), with start() of soft_corner.cpp.
  static constexpr double equal_swings = 5.3558125;

  /// Returns the shape for a corner where the change of direction has the magnitude |Δu| = `bend` (0 … 2).
  static const SoftCorner& of(double bend);

  /// g, g′, g″ at the distance r ≥ 0 from the corner, for w = 1. g is an even function; `slope` is g′(−r), and g′(r) has the opposite sign.
  struct Shape {
    double g, slope, pulse;
  };
  Shape at(double r) const;
  /// Returns the displacement g at the distance r from the corner, for w = 1.
  ///   pre  r < 1
  double height(double r) const {
    const double place = r * pieces;
    const auto i = static_cast<std::size_t>(place);
    const double h = place - static_cast<double>(i);
    const std::array<double, 4>& c = cubic_[i];
    return c[0] + h * (c[1] + h * (c[2] + h * c[3]));
  }

  double highest() const { return highest_; }              // the greatest |g|, for w = 1
  double second_moment() const { return second_moment_; }  // |∫ g|: the displacement of a curve with curvature 1, for w = 1
  double flank() const { return flank_; }                  // the distance r of the greatest deviation to the outside
  static constexpr int cells = 16;                         // number of equal cells on each side that reproduce the shape exactly

 private:
  explicit SoftCorner(bool sharp);

  static constexpr int pieces = 32;  // k is linear in each piece: g‴ is constant there
  std::array<double, pieces + 2> k_{}, slope_{}, g_{};
  std::array<std::array<double, 4>, pieces + 1> cubic_{};  // g in each piece, by the fraction of the piece
  double highest_ = 0, flank_ = 0, second_moment_ = 0;
};

}  // namespace kadr
