#pragma once
// OverrideRamp is a smooth change from one override to another, so that acceleration and jerk stay bounded. `share` is the override as a
// factor of the planned speed, 0 to 1. Playback advances plan time at the rate `share`: plan time = ∫ share dt.

#include <array>

namespace kadr {

/// The override as a factor of the planned speed (0: feed hold, 1: as planned) and its first two derivatives with respect to time, in 1/s
/// and 1/s².
struct OverrideFactor {
  double share = 1, rate = 0, bend = 0;
};

class OverrideRamp {
 public:
  /// Creates a ramp with a constant override.
  explicit OverrideRamp(double share) : end_(share) { c_[0] = share; }
  /// Creates a ramp from the override `from` to the override `to` that takes `seconds`, greater than 0. The override is a polynomial of the
  /// fifth degree whose first and second derivatives are 0 at the end of the ramp.
  OverrideRamp(OverrideFactor from, double to, double seconds);

  double seconds() const { return seconds_; }
  /// The override at the end of the ramp and after it, 0 to 1.
  double end() const { return end_; }
  OverrideFactor at(double t) const;
  /// Plan time, s, that elapses in the first `t` seconds of the ramp: ∫ share dt.
  double passed(double t) const;

 private:
  double seconds_ = 0, end_;
  std::array<double, 6> c_{};
};

}  // namespace kadr
