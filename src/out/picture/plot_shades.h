#pragma once
// Colours a path by its speed or by what limits it (kadr run --colour): motions wait until the planner of least time has timed them, then
// they are drawn piece by piece, each with its shade. The planner's window limits how many motions wait.

#include <deque>

#include "action/step.h"
#include "action/tool_position.h"
#include "kinematics/chain.h"
#include "motion/look_ahead/limited_by.h"
#include "out/picture/plot_path.h"

namespace kadr {

struct Colour;

/// What the colour of a path means. The shade is, for `speed`, mm/min, and for `limit`, the number of the Limit.
enum class PlotColour : std::uint8_t { stroke, speed, limit };

class ShadedMotions {
 public:
  ShadedMotions(const AxisRoles& roles, PlotColour by) : roles_(roles), chain_(roles), by_(by) {}

  /// Adds a motion that begins where the tool is; `shift`: work coordinates → picture.
  void wait(const Motion& motion, const ToolPosition& from, Vec3 shift, Stroke stroke, ProgramLine line);
  /// Sets, for the motion added last and before its cells come, its number (CellSource::motion) and the approximate length of its cells,
  /// mm.
  void set_motion(std::uint64_t number, double way) {
    waiting_.back().number = number;
    waiting_.back().way = way;
  }
  /// Moves the waiting motions, and what is drawn of them, by this vector in the picture.
  void move_all(Vec3 by);

  void take(const TimedCells& cells, const MotionLimits& limits, PlotPath& path);
  /// Draws what still waits: only what rounding has left over.
  void finish(PlotPath& path);

 private:
  /// When its cells come the machine is elsewhere, so a waiting motion keeps its starting position.
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
  double gone_ = 0;   // mm of cells consumed for the first waiting motion
  double drawn_ = 0;  // the fraction of it that is drawn
  PlotPoint held_{};  // not yet in the path: the next point may continue in the same direction and shade
  bool holds_ = false;
};

/// Maps shades to colours, in steps of a scale.
class ShadeScale {
 public:
  /// Builds the scale for the cutting of a path.
  ShadeScale(PlotColour by, const PlotPath& path);

  PlotColour by() const { return by_; }
  std::size_t steps() const;
  std::size_t step_of(float shade) const;
  Colour ink(std::size_t step) const;
  /// True if some of the path has this step.
  bool occurs(std::size_t step) const { return (occurs_ >> step & 1U) != 0; }
  /// For speeds: the end of the scale, mm/min.
  double top() const { return top_; }

 private:
  PlotColour by_;
  double top_ = 1;
  std::uint32_t occurs_ = 0;
};

}  // namespace kadr
