#pragma once
// TimedCells is a segment of a path with its timing. The planner emits TimedCells; Playback and other readers compute axis positions from
// them.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kadr {

/// The distance s along a cell as a function of the time t. The distance grows from 0 to `length` in `seconds`.
struct TimeLaw {
  double seconds = 0, length = 0;  // s, mm
  bool by_time = true;             // True: s = v t + a t²/2 + j t³/6. False: the acceleration depends on the distance, s̈ = a + j s.
  double v = 0, a = 0, j = 0;

  double distance(double t) const;
  double speed(double t) const;
  /// The distance along the path, mm, and its first three time derivatives in mm/s, mm/s² and mm/s³.
  struct State {
    double distance = 0, speed = 0, acceleration = 0, jerk = 0;
  };
  State after(double t) const;
  /// Returns the state at the fraction `part` of the cell: a fraction of its duration if `by_time` is true, otherwise a fraction of its
  /// length.
  State at(double part) const;

  /// Returns the distance-time law of a cell with the constant jerk `j`, mm/s³, that lasts `seconds`. `v` and `a` are the speed and the
  /// acceleration at its start.
  static TimeLaw of_jerk(double seconds, double v, double a, double j);
  /// Returns the distance-time law of a cell in which ṡ² = v² + 2 a s + j s² from s = 0 to `length`, where ṡ is the path speed. This
  /// polynomial must be positive for every s in this range.
  static TimeLaw of_squares(double length, double v, double a, double j);
  /// Returns the distance-time law of a cell in which the axes start from rest with constant jerk and reach the speed `v` at the distance
  /// `length`. If `reversed` is true, the axes slow down from `v` to rest instead.
  static TimeLaw from_rest(double length, double v, bool reversed);
};

/// The shape of the path in a cell: straight, or part of a rounding.
enum class Bend : std::uint8_t {
  none,    // the path is straight
  corner,  // the cell lies in the rounding of a programmed corner
  curve,   // the cell lies in the rounding between two chords of a curve
};

/// The operator's switches that have an effect in a cell.
struct Switches {
  bool feed_override = true, hold = true;
};

/// The path piece from which a cell was made.
struct CellSource {
  std::uint64_t tag = 0;  // tag of the piece in which the cell starts; the caller defines the meaning of the tag
  double feed = 0;        // the greatest commanded path speed, mm/s; 0: the axes are at rest
  Bend bend = Bend::none;
  std::uint64_t motion = 0;  // number of the motion in which the cell starts, as AxisMotion counts motions; 0: unknown
  Switches switches{};
  // The greatest excess of the path's deviation over the tolerance at the sample positions, as a fraction of the tolerance.
  double beyond = 0;
};

/// The spindle's angle in a cell in degrees, not reduced modulo 360. The angle grows with time, or in rigid tapping with the distance that
/// the axes travel.
struct SpindleTurn {
  double angle = 0, per_second = 0, per_mm = 0;
  // True if the axes wait at the end of this cell until the spindle angle, modulo 360°, equals the planned angle. The axes are then
  // synchronised with the spindle.
  bool awaited = false;
  // True if the angle was commanded. At the start of the cell the spindle angle then equals the planned angle modulo 360°.
  bool absolute = false;

  double at(double t, double distance) const { return angle + per_second * t + per_mm * distance; }
};

/// Consecutive cells, each with its timing and the polynomials of the axis positions.
struct TimedCells {
  static constexpr std::size_t terms = 6;

  std::size_t axes = 0;
  std::vector<TimeLaw> laws;
  std::vector<CellSource> sources;
  // The coefficients c_i of x(s) = Σ c_i s^i for each cell and axis. The index of c_0 is (cell * axes + axis) * terms.
  std::vector<double> path;
  std::vector<SpindleTurn> spindle{};  // angle and rotation of the spindle in each cell; empty: they are not computed yet
  bool unsolved = false;               // True if no speed was found for these cells. The axes then stop after each of these cells.

  void clear() { laws.clear(), sources.clear(), path.clear(), spindle.clear(), unsolved = false; }
  /// Writes to `x` the axis positions at the distance `distance`, mm, from the start of a cell.
  void position(std::size_t cell, double distance, double* x) const;
  double seconds() const;
};

}  // namespace kadr
