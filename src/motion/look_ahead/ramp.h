#pragma once
// Ramp is a change of speed along the path, with linear, bell-shaped or jerk-free acceleration: NCT 7.0.
//
//   acceleration   ┌────┐        /────\           the set acceleration is reached at once (linear) or within `build_up` (bell-shaped: │
//                  │       /      \          linearly; jerk-free: along half a cosine); if the change of speed is too small for
//               ───┘    └───  ─/        \───      that, the peak is lower and the build-up equally steep
//
// Speeds are in mm/s, accelerations in mm/s², lengths in mm and times in s. Where only rotary axes move, degrees replace mm.

#include <limits>

namespace kadr {

/// The acceleration with which the speed along a path may change.
struct Acceleration {
  double most = std::numeric_limits<double>::infinity();  // greatest acceleration, mm/s²; infinite: the speed changes instantly
  double build_up = 0;                                    // time until `most` is reached, s; 0: linear ramp
  // Parameter N0421 #1 JRK, the jerk-free ramp. INFERRED: its acceleration builds up along half a cosine; it takes the same time and the
  // same length as the bell-shaped ramp.
  bool jerk_free = false;
};

/// Returns the duration, s, of a ramp that changes the speed by `change`.
///   law  with D = |change|, a = acceleration, T = build-up time: linear D/a; bell-shaped D/a + T where D ≥ a·T, else 2·√(D·T/a)
double ramp_seconds(double change, const Acceleration& acceleration);

/// Returns the length, mm, of a ramp between two speeds, up or down. The length is the mean of the two speeds times the duration of the
/// ramp.
double ramp_length(double from, double to, const Acceleration& acceleration);

/// Returns the speed that a complete ramp from the speed `from` reaches over the distance `length`. At this distance the acceleration is 0
/// again.
///   law  ramp_length(from, reached(from, L, a), a) == L
double reached(double from, double length, const Acceleration& acceleration);

/// Returns the highest speed on a path of the length `length` that starts at the speed `from` and ends at the speed `to`. The result is at
/// most `most`, but at least the higher of `from` and `to`.
double top_speed(double from, double to, double length, double most, const Acceleration& acceleration);

/// Returns the time, s, for a path of the length `length` that starts at the speed `from` and ends at the speed `to`: a ramp up to the top
/// speed, constant speed, and a ramp down. If `length` is too short for the ramp, the speed changes linearly.
double travel_seconds(double from, double to, double length, double most, const Acceleration& acceleration);

/// A single change of speed, which can be evaluated at any time or position.
class Ramp {
 public:
  Ramp(double from, double to, const Acceleration& acceleration);
  double seconds() const { return seconds_; }
  double length() const { return length_; }
  /// Returns the time, s, at which the distance `at`, mm from the start of the ramp, is reached.
  double seconds_at(double at) const;
  double speed_at(double seconds) const;

 private:
  struct Moment {
    // `distance` is the distance since the start of the ramp, mm; `gained` is the absolute change of speed since the start of the ramp,
    // mm/s.
    double distance, gained;
  };
  Moment rising(double seconds, double start_speed, double sign) const;
  double distance_at(double seconds) const;

  double from_, to_;
  double peak_ = 0;      // the greatest acceleration of the ramp, mm/s²
  double build_up_ = 0;  // time until the acceleration `peak_` is reached, s
  bool jerk_free_;
  double seconds_, length_;
};

}  // namespace kadr
