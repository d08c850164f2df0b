#pragma once
// A change of speed along the path, with linear, bell-shaped or jerk-free acceleration. NCT 7.0.
//
//   acceleration   ┌────┐        /────\           the set acceleration is reached at once (linear) or within `build_up` (bell-shaped:
//                  │    │       /      \          linearly; jerk-free: along half a cosine); if the change of speed is too small for
//               ───┘    └───  ─/        \───      that, the peak is lower and the build-up equally steep
//
// Speeds mm/s, accelerations mm/s², lengths mm, times s; degrees instead of mm where only rotary axes move.

#include <limits>

namespace kadr {

/// The acceleration with which the speed along a path may change.
struct Acceleration {
  double most = std::numeric_limits<double>::infinity();  // mm/s²; infinite: the speed changes instantly
  double build_up = 0;                                    // time until `most` is reached, s; 0: linear ramp
  // N0421 #1 JRK; INFERRED: the acceleration follows half a cosine, with the same time and distance
  bool jerk_free = false;
};

/// Returns the duration of a ramp that changes the speed by `change`.
///   law  with D = |change|, a = acceleration, T = build-up time: linear D/a; bell-shaped D/a + T where D ≥ a·T, else 2·√(D·T/a)
double ramp_seconds(double change, const Acceleration& acceleration);

/// Returns the length of a ramp between two speeds, up or down: the mean of the two speeds times the duration of the ramp.
double ramp_length(double from, double to, const Acceleration& acceleration);

/// Returns the speed that a ramp starting at the speed `from` reaches at the distance `length`, where the acceleration is 0 again.
///   law  ramp_length(from, reached(from, L, a), a) == L
double reached(double from, double length, const Acceleration& acceleration);

/// Returns the highest speed on a path of `length` with the speeds `from` and `to` at its ends. The result is at most `most`, but at
/// least the higher of `from` and `to`.
double top_speed(double from, double to, double length, double most, const Acceleration& acceleration);

/// Returns the time for a path of `length` with the speeds `from` and `to` at its ends: ramp up to the top speed, constant speed, ramp
/// down. If `length` is too short for the ramp, the speed changes linearly.
double travel_seconds(double from, double to, double length, double most, const Acceleration& acceleration);

/// A single change of speed, which can be evaluated at any time or position.
class Ramp {
 public:
  Ramp(double from, double to, const Acceleration& acceleration);
  double seconds() const { return seconds_; }
  double length() const { return length_; }
  /// Returns the time at which the position `at`, mm from the start, is reached.
  double seconds_at(double at) const;
  double speed_at(double seconds) const;

 private:
  struct Moment {
    double way, gained;  // way: distance since the start of the ramp; gained: absolute change of speed since then
  };
  Moment rising(double seconds, double start_speed, double sign) const;
  double way_at(double seconds) const;

  double from_, to_;
  double peak_ = 0;      // the greatest acceleration of the ramp, mm/s²
  double build_up_ = 0;  // time until the acceleration `peak_` is reached, s
  bool jerk_free_;
  double seconds_, length_;
};

}  // namespace kadr
