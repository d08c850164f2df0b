#pragma once
// TimedCells: a segment of a path with its timing. The planner emits TimedCells; Playback and others sample axis positions from them.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kadr {

/// The distance s along a cell as a function of time t: s grows from 0 to `length` in `seconds`.
struct TimeLaw {
  double seconds = 0, length = 0;  // s, mm
  bool by_time = true;             // true: s = v t + a t²/2 + j t³/6; false: the acceleration depends on the distance, s̈ = a + j s
  double v = 0, a = 0, j = 0;

  double way(double t) const;
  double speed(double t) const;
  /// Distance and its time derivatives along the path: mm, mm/s, mm/s², mm/s³.
  struct State {
    double way = 0, speed = 0, acceleration = 0, jerk = 0;
  };
  State after(double t) const;
  /// The state at the fraction `part` of the cell: a fraction of its duration if `by_time`, else of its length.
  State at(double part) const;

  /// Returns a law with constant jerk `j`, mm/s³, that lasts `seconds`.
  static TimeLaw of_jerk(double seconds, double v, double a, double j);
  /// Returns a law with ṡ² = v² + 2 a s + j s² up to `length`; this polynomial must be positive throughout.
  static TimeLaw of_squares(double length, double v, double a, double j);
  /// Returns a law with constant jerk from rest to the speed `v` at `length`; with `reversed`, from the speed `v` to rest.
  static TimeLaw from_rest(double length, double v, bool reversed);
};

/// How the path bends in a cell.
enum class Bend : std::uint8_t {
  none,    // the path is straight
  corner,  // the cell lies in the rounding of a programmed corner
  curve,   // the cell lies in the rounding between two chords of a curve
};

/// Which of the operator's switches act in a cell.
struct Switches {
  bool feed_override = true, hold = true;
};

/// The piece of path that a cell was cut from.
struct CellSource {
  std::uint64_t tag = 0;  // tag of the piece in which the cell starts; the caller defines its meaning
  double feed = 0;        // the greatest commanded path speed, mm/s; 0: the axes are at rest
  Bend bend = Bend::none;
  std::uint64_t motion = 0;  // number of the motion in which the cell starts, counted by AxisMotion; 0: unknown
  Switches switches{};
  double beyond = 0;  // greatest excess of the path's deviation over the tolerance at the sample positions, as a share of the tolerance
};

/// The spindle's angle in a cell, in degrees, not reduced modulo 360. It grows with time, or with the distance that the axes travel
/// (rigid tapping).
struct SpindleTurn {
  double angle = 0, per_second = 0, per_mm = 0;
  // the axes are synchronised after this cell: at its end they wait until the angle, modulo 360°, equals the planned one
  bool awaited = false;
  bool absolute = false;  // the angle was commanded: at the start of the cell it equals the planned angle modulo 360°

  double at(double t, double way) const { return angle + per_second * t + per_mm * way; }
};

/// Consecutive cells, each with its timing and the polynomials of the axis positions.
struct TimedCells {
  static constexpr std::size_t terms = 6;

  std::size_t axes = 0;
  std::vector<TimeLaw> laws;
  std::vector<CellSource> sources;
  // coefficients c_i of x(s) = Σ c_i s^i for each cell and axis; index of c_0: (cell * axes + axis) * terms
  std::vector<double> path;
  std::vector<SpindleTurn> spindle{};  // one per cell; empty: not set yet
  bool unsolved = false;               // no speed was found for these cells: the axes stop after each of them

  void clear() { laws.clear(), sources.clear(), path.clear(), spindle.clear(), unsolved = false; }
  /// Writes to `x` the axis positions at the distance `way`, mm, from the start of a cell.
  void position(std::size_t cell, double way, double* x) const;
  double seconds() const;
};

}  // namespace kadr
