#pragma once
// OverrideRamp: a smooth change from one override to another, so that acceleration and jerk stay bounded. The override is expressed as
// the share of the planned speed. The plan is played at the rate `share`: plan time = ∫ share dt.

#include <array>

namespace kadr {

/// Share of the planned speed (0: feed hold, 1: as planned) and its first two derivatives with respect to time, 1/s and 1/s².
struct OverrideFactor {
  double share = 1, rate = 0, bend = 0;
};

class OverrideRamp {
 public:
  /// A constant share.
  explicit OverrideRamp(double share) : end_(share) { c_[0] = share; }
  /// A ramp from `from` to the share `to` in `seconds` > 0: a polynomial of the fifth degree whose first and second derivatives are 0 at
  /// the end.
  OverrideRamp(OverrideFactor from, double to, double seconds);

  double seconds() const { return seconds_; }
  /// The share at the end of the ramp and after it.
  double end() const { return end_; }
  OverrideFactor at(double t) const;
  /// Plan time that passes in the first t seconds of the ramp: ∫ share dt.
  double passed(double t) const;

 private:
  double seconds_ = 0, end_;
  std::array<double, 6> c_{};
};

}  // namespace kadr
