#pragma once
// A path coloured by its speed or by what limits it (kadr run --colour): motions wait until the planner of least time has timed them, then
// they are drawn piece by piece, each with its shade. What waits is bounded by the planner's window.

#include <deque>

#include "action/step.h"
#include "action/tool_position.h"
#include "kinematics/chain.h"
#include "motion/look_ahead/limited_by.h"
#include "out/picture/plot_path.h"

namespace kadr {

struct Colour;

/// What the colour of a path means. A shade: of `speed` mm/min, of `limit` the number of the Limit.
enum class PlotColour : std::uint8_t { stroke, speed, limit };

class ShadedMotions {
 public:
  ShadedMotions(const AxisRoles& roles, PlotColour by) : roles_(roles), chain_(roles), by_(by) {}

  /// A motion from where the tool stands; `shift`: work coordinates → picture.
  void wait(const Motion& motion, const ToolPosition& from, Vec3 shift, Stroke stroke, ProgramLine line);
  /// Of the one that came last, before its cells come: its number, CellSource::motion, and the way of its cells, mm, about.
  void set_motion(std::uint64_t number, double way) {
    waiting_.back().number = number;
    waiting_.back().way = way;
  }
  /// The motions that wait, and what of them is drawn, move by that much in the picture.
  void move_all(Vec3 by);

  void take(const TimedCells& cells, const MotionLimits& limits, PlotPath& path);
  /// What is left: nothing but what rounding has left over.
  void finish(PlotPath& path);

 private:
  /// Its cells come when the machine is elsewhere: it keeps where it began.
  struct Waiting {
    Motion motion;
    ToolPosition from;
    Vec3 shift;
    Stroke stroke;
    ProgramLine line;
    std::uint64_t number;
    double way;
  };
  void draw_to(double way, float shade, PlotPath& path);
  void draw_rest(float shade, PlotPath& path);
  void draw_part(const Waiting& motion, double from, double to, float shade, PlotPath& path);
  void keep(PlotPoint point, bool may_replace, PlotPath& path);
  void let_go(PlotPath& path);

  AxisRoles roles_;
  Chain chain_;
  PlotColour by_;
  std::deque<Waiting> waiting_;
  double gone_ = 0;   // mm, of the first that waits
  double drawn_ = 0;  // part of it
  PlotPoint held_{};  // not yet in the path: the next may go on in the same line and shade
  bool holds_ = false;
};

/// How shades become colours: steps of a scale.
class ShadeScale {
 public:
  /// Of the cutting of a path.
  ShadeScale(PlotColour by, const PlotPath& path);

  PlotColour by() const { return by_; }
  std::size_t steps() const;
  std::size_t step_of(float shade) const;
  Colour ink(std::size_t step) const;
  /// Some of the path has this step.
  bool occurs(std::size_t step) const { return (occurs_ >> step & 1U) != 0; }
  /// Of speeds: the end of the scale, mm/min.
  double top() const { return top_; }

 private:
  PlotColour by_;
  double top_ = 1;
  std::uint32_t occurs_ = 0;
};

}  // namespace kadr
