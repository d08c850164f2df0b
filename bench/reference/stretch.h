#pragma once
// Stretch: a part of the planned motion between two rests of the axes, with the path as the planner rounds it, and its time. The
// reference solvers get the same path and the same limits.

#include <string>
#include <vector>

#include "motion/least_time/planner.h"

namespace kadr::reference {

struct Stretch {
  TimedCells cells;
  std::vector<double> feed;  // greatest path speed in each cell, mm/s
};

/// The path at one point: derivatives of the axis positions with respect to path length, and the greatest ṡ² (squared path speed) that
/// feed and axes allow there, mm²/s².
struct Place {
  std::array<double, max_axes> x1{}, x2{}, x3{};
  double most = 0;
};
Place place(const Stretch& stretch, const MotionLimits& limits, std::size_t cell, double way);

/// A stretch divided into intervals, each within one cell.
struct Grid {
  std::vector<double> h;          // length of each interval, mm
  std::vector<Place> start, end;  // the path at the start and the end of each interval
  std::vector<std::size_t> cell;
  std::vector<double> from;  // start of each interval, mm from the start of its cell

  std::size_t intervals() const { return h.size(); }
  double most(std::size_t knot) const;
};
///   parts    number of intervals per cell
///   longest  greatest length of an interval, as a share of the stretch
Grid grid_of(const Stretch& stretch, const MotionLimits& limits, int parts, double longest);

/// Path speed and path acceleration at the knots of a grid, and the time of each interval.
struct PathMotion {
  std::vector<double> v, a, seconds;
  double total() const;
};
/// Returns the motion that the planner computed.
PathMotion motion_of(const Stretch& stretch, const Grid& grid);

/// The greatest shares of the speed, acceleration and jerk limits that a motion uses.
struct Shares {
  double speed = 0, acceleration = 0, jerk = 0;
  void take(const Place& at, const MotionLimits& limits, double v, double a, double j);
};
Shares shares_planned(const Stretch& stretch, const MotionLimits& limits);
/// Returns the shares of a motion with constant path jerk in each interval.
Shares shares_of(const Stretch& stretch, const MotionLimits& limits, const Grid& grid, const PathMotion& motion);

/// Returns the time of the whole stretch if motion/least_time/least_time plans it as one window; the planner's own time if the stretch is
/// a single straight line.
double seconds_as_one_window(const Stretch& stretch, const MotionLimits& limits);

/// The limits of each axis (mm/s, mm/s², mm/s³) and the path tolerance, mm.
struct Machine {
  double speed = 200, acceleration = 1000, jerk = 20000, tolerance = 0.01;
};
struct Planned {
  MotionLimits limits;
  std::vector<Stretch> stretches;
};
/// Reads a program for the control mach3 and plans its motion on a machine with these limits.
///   throws  std::runtime_error for alarms, unreadable files, and paths that reverse
Planned planned(const std::string& file, const Machine& machine);

}  // namespace kadr::reference
