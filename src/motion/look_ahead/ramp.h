#pragma once
// A change of speed along the path: linear, bell-shaped or jerk-free acceleration. NCT 7.0.
//
//   acceleration   ┌────┐        /────\           the set one is reached at once (linear) or within `build_up` (bell-shaped: evenly,
//                  │    │       /      \          jerk-free: along half a cosine); where the change of speed is too small for
//               ───┘    └───  ─/        \───      that, the peak is lower and the build-up as steep
//
// Speeds mm/s, accelerations mm/s², lengths mm, times s; degrees for mm where only rotary axes move.

#include <limits>

namespace kadr {

/// How a path may change its speed.
struct Acceleration {
  double most = std::numeric_limits<double>::infinity();  // infinite: speeds change at once
  double build_up = 0;                                    // s until it is reached; 0: linear
  bool jerk_free = false;                                 // N0421 #1 JRK; INFERRED: half a cosine, which takes the same time and way
};

/// Time of a change of speed by `change`.
///   law  linear D/a; bell-shaped D/a + T where D ≥ a·T, else 2·√(D·T/a)
double ramp_seconds(double change, const Acceleration& acceleration);

/// Way of a ramp between two speeds, in either direction: their mean times its time.
double ramp_length(double from, double to, const Acceleration& acceleration);

/// The speed that is reached within `length`, the acceleration back at zero.
///   law  ramp_length(from, reached(from, L, a), a) == L
double reached(double from, double length, const Acceleration& acceleration);

/// The highest speed on a way of `length` that begins and ends with the given ones; at most `most`, at least the higher of the two.
double top_speed(double from, double to, double length, double most, const Acceleration& acceleration);

/// Time of such a way: up to the top speed, on with it, down. Where `length` does not suffice for the change of speed, evenly.
double way_seconds(double from, double to, double length, double most, const Acceleration& acceleration);

/// One ramp, to be asked for what lies within it.
class Ramp {
 public:
  Ramp(double from, double to, const Acceleration& acceleration);
  double seconds() const { return seconds_; }
  double length() const { return length_; }
  /// When the point `at` mm from its start is passed.
  double seconds_at(double at) const;
  double speed_at(double seconds) const;

 private:
  struct Moment {
    double way, gained;  // since the start of a ramp, of speed: its amount
  };
  Moment rising(double seconds, double start_speed, double sign) const;
  double way_at(double seconds) const;

  double from_, to_;
  double peak_ = 0;      // acceleration, mm/s²
  double build_up_ = 0;  // s until it is reached
  bool jerk_free_;
  double seconds_, length_;
};

}  // namespace kadr
