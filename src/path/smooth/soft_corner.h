#pragma once
// SoftCorner is the shape by which a corner of a path is rounded, so that the third derivative of the path stays bounded.
//
// At a corner the direction of a path of straight pieces jumps by Δu, so the second derivative of the path is a pulse. The rounding spreads
// the pulse over the range from −w to w as Δu k(s), where w is the width of the rounding and s the distance from the corner. The path then
// moves by Δu g(s), with g″ = k. If the pulse has negative parts, the path deviates to the outside before and after the corner, by the same
// distance as to the inside at the corner. For the same deviation the corner then needs a third to a sixth of the jerk.
//
//   gentle corner   the speed is constant in the rounding: g‴ = ±c, with c constant
//   sharp corner    the speed falls towards the corner and rises after it, as on a machine whose axes stop and start one after
//                   the other with constant jerk: the shape is defined over time and mapped to the path; derived for a corner of 90°
//
// In both shapes the deviation at the corner equals the greatest deviation to the outside. The shapes were found as perfect splines (Karlin
// 1975). The derivation is the work of this project.

#include <array>
#include <cstddef>

namespace kadr {

class SoftCorner {
 public:
  // The greatest width of a rounding to either side, mm. Wider roundings take computing time and gain little at feeds below 12 m/min.
  static constexpr double widest = 2;
  /// A time in the shape of the sharp corner, in which the starting axis moves backwards at first. At this time the axis is as far in front
  /// of its start position as it was behind it at most: start(equal_swings) = −start(2 + √2), with start() of soft_corner.cpp.
  static constexpr double equal_swings = 5.3558125;

  /// Returns the shape for a corner whose change of direction has the magnitude |Δu| = `bend`, 0 to 2.
  static const SoftCorner& of(double bend);

  /// The displacement g of the path and its derivatives g′ and g″ at the distance r ≥ 0 from the corner, for a rounding of the width 1. The
  /// function g is even. `slope` is g′(−r); g′(r) has the opposite sign.
  struct Shape {
    double g, slope, pulse;
  };
  Shape at(double r) const;
  /// Returns the displacement g of the path at the distance r from the corner, for a rounding of the width 1.
  ///   pre  r < 1
  double height(double r) const {
    const double place = r * pieces;
    const auto i = static_cast<std::size_t>(place);
    const double h = place - static_cast<double>(i);
    const std::array<double, 4>& c = cubic_[i];
    return c[0] + h * (c[1] + h * (c[2] + h * c[3]));
  }

  double highest() const { return highest_; }  // the greatest displacement |g| of the path, for a rounding of the width 1
  // the displacement |∫ g| of a curve whose curvature is 1, for roundings of the width 1
  double second_moment() const { return second_moment_; }
  // distance r from the corner at which the deviation to the outside is greatest, for a rounding of the width 1
  double flank() const { return flank_; }
  // number of equal cells on each side of the corner with which the planner reproduces the shape of the rounding exactly
  static constexpr int cells = 16;

 private:
  explicit SoftCorner(bool sharp);

  // number of pieces of the shape on each side of the corner; in each piece k is linear, so g‴ is constant
  static constexpr int pieces = 32;
  std::array<double, pieces + 2> k_{}, slope_{}, g_{};
  // coefficients of the displacement g in each piece, as a polynomial in the fraction of the piece
  std::array<std::array<double, 4>, pieces + 1> cubic_{};
  double highest_ = 0, flank_ = 0, second_moment_ = 0;
};

}  // namespace kadr
