#pragma once
// SoftCorner: how a corner of a path is rounded so that the third derivative of the path stays bounded.
//
// At a corner the direction of a path of straight pieces jumps by Δu: its second derivative is a pulse. The pulse is spread over [−w, w]
// as Δu k(s), which moves the path by Δu g(s), g″ = k. A pulse with negative parts lets the path swing out before and after the corner as
// far as it cuts the corner: for the same deviation the corner needs a third to a sixth of the jerk.
//
//   gentle corner   the speed is constant while the corner is passed: g‴ = ±c
//   sharp corner    the speed falls towards the corner and rises after it, as on a machine whose axes stop and start one after
//                   the other with constant jerk: the same over time, mapped to the path; derived for 90°
//
// Both have the same deviation at the corner and where they swing out most. Found as perfect splines (Karlin 1975); our own work.

#include <array>
#include <cstddef>

namespace kadr {

class SoftCorner {
 public:
  static constexpr double widest = 2;  // mm, of a rounding to either side; wider ones cost work and gain little below 12 m/min
  /// Where the start of an axis that swings back first is as far on one side as it was on the other: start(equal) = −start(2 + √2).
  static constexpr double equal_swings = 5.3558125;

  /// Returns the shape for a corner with this |Δu| (0 … 2).
  static const SoftCorner& of(double bend);

  /// g, g′, g″ at a distance r ≥ 0 from the corner, for w = 1; g is even, g′ is given for −r (at +r it has the opposite sign).
  struct Shape {
    double g, slope, pulse;
  };
  Shape at(double r) const;
  /// Returns g alone.
  ///   pre  r < 1
  double height(double r) const {
    const double place = r * pieces;
    const auto i = static_cast<std::size_t>(place);
    const double h = place - static_cast<double>(i);
    const std::array<double, 4>& c = cubic_[i];
    return c[0] + h * (c[1] + h * (c[2] + h * c[3]));
  }

  double highest() const { return highest_; }              // the greatest |g|, for w = 1
  double second_moment() const { return second_moment_; }  // |∫ g|: how far a curve with curvature 1 is moved, for w = 1
  double flank() const { return flank_; }                  // where it swings out most
  static constexpr int cells = 16;                         // this many equal cells on each side reproduce its shape

 private:
  explicit SoftCorner(bool sharp);

  static constexpr int pieces = 32;  // k is linear in each piece: g‴ is constant there
  std::array<double, pieces + 2> k_{}, slope_{}, g_{};
  std::array<std::array<double, 4>, pieces + 1> cubic_{};  // g in each piece, by the fraction of the piece
  double highest_ = 0, flank_ = 0, second_moment_ = 0;
};

}  // namespace kadr
