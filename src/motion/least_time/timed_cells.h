#pragma once
// TimedCells: a stretch of path with its time: what a planner emits, what positions are sampled from.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kadr {

/// How far along a cell after a time: from 0 to `length` in `seconds`.
struct TimeLaw {
  double seconds = 0, length = 0;  // mm
  bool by_time = true;             // s = v t + a t²/2 + j t³/6; else by the way gone: s̈ = a + j s
  double v = 0, a = 0, j = 0;

  double way(double t) const;
  double speed(double t) const;
  /// Along the path: mm, mm/s, mm/s², mm/s³.
  struct State {
    double way = 0, speed = 0, acceleration = 0, jerk = 0;
  };
  State after(double t) const;
  /// At a part of it: of the time, or where it goes by the way of that.
  State at(double part) const;

  /// With a given jerk, mm/s³, for a time.
  static TimeLaw of_jerk(double seconds, double v, double a, double j);
  /// ṡ² = v² + 2 a s + j s² until `length`; greater than 0 all along.
  static TimeLaw of_squares(double length, double v, double a, double j);
  /// From rest to the speed `v` at `length` with constant jerk; `reversed`: from there to rest.
  static TimeLaw from_rest(double length, double v, bool reversed);
};

/// How the path bends there.
enum class Bend : std::uint8_t {
  none,    // straight
  corner,  // within the rounding of a corner
  curve,   // within that between two chords of a curve
};

/// Which of the operator's switches act there.
struct Switches {
  bool feed_override = true, hold = true;
};

/// What a cell was made of.
struct CellSource {
  std::uint64_t tag = 0;  // of the piece where it begins: the caller's own
  double feed = 0;        // mm/s, the greatest speed commanded; 0: the axes stand
  Bend bend = Bend::none;
  std::uint64_t motion = 0;  // that it begins in, counted by AxisMotion; 0: the planner has not told
  Switches switches{};
  double beyond = 0;  // how far the path is beyond its tolerance, as a share of it, in the places looked at
};

/// The spindle's angle along a cell, running degrees: over the time, or with the way of the axes (rigid tapping).
struct SpindleTurn {
  double angle = 0, per_second = 0, per_mm = 0;
  bool awaited =
      false;  // at the cell's end the axes go in step with it: they stand until the angle, but for whole turns, is the planned one
  bool absolute = false;  // the angle was commanded: where it begins, it is the planned one but for whole turns

  double at(double t, double way) const { return angle + per_second * t + per_mm * way; }
};

/// Cells in a row, each with the polynomial of its path.
struct TimedCells {
  static constexpr std::size_t terms = 6;

  std::size_t axes = 0;
  std::vector<TimeLaw> laws;
  std::vector<CellSource> sources;
  std::vector<double> path;            // x(s) of each cell and axis: Σ c_i s^i, c at (cell * axes + axis) * terms
  std::vector<SpindleTurn> spindle{};  // of each cell; empty: nobody has told
  bool unsolved = false;               // no speed was found for them: the axes stand after each

  void clear() { laws.clear(), sources.clear(), path.clear(), spindle.clear(), unsolved = false; }
  /// Axis positions at a way along a cell.
  void position(std::size_t cell, double way, double* x) const;
  double seconds() const;
};

}  // namespace kadr
