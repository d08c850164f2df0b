#pragma once
// OverrideRamp: how the share of the planned speed changes from one override to another: smoothly, so that acceleration and jerk
// stay bounded. Time on the plan runs as fast as the share says.

#include <array>

namespace kadr {

/// Share of the planned speed (0: feed hold, 1: as planned) with its first two derivatives by time, 1/s and 1/s².
struct OverrideShare {
  double share = 1, rate = 0, bend = 0;
};

class OverrideRamp {
 public:
  /// Nothing changes.
  explicit OverrideRamp(double share) : end_(share) { c_[0] = share; }
  /// From `from` to the share `to` in `seconds` > 0: the polynomial of the fifth degree that ends without rate and bend.
  OverrideRamp(OverrideShare from, double to, double seconds);

  double seconds() const { return seconds_; }
  /// The share after it.
  double end() const { return end_; }
  OverrideShare at(double t) const;
  /// Time on the plan that has passed after t: ∫ share.
  double passed(double t) const;

 private:
  double seconds_ = 0, end_;
  std::array<double, 6> c_{};
};

}  // namespace kadr
