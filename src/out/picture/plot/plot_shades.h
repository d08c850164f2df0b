#pragma once
// Colours a path by its speed, or by what limits the speed (kadr run --colour). A motion waits until the planner of least time has sent
// its cells (short timed segments); then it is drawn as pieces, each with its shade. The planner's window limits the number of waiting
// motions.

#include <deque>

#include "action/step.h"
#include "action/tool_position.h"
#include "kinematics/chain.h"
#include "motion/look_ahead/limited_by.h"
#include "out/picture/plot/plot_path.h"

namespace kadr {

struct Colour;

/// What the colour of a path shows. PlotPoint::shade is the speed in mm/min for `speed`, and the number of the enum value Limit for
/// `limit`.
enum class PlotColour : std::uint8_t { stroke, speed, limit };

class ShadedMotions {
 public:
  ShadedMotions(const AxisRoles& roles, PlotColour by) : roles_(roles), chain_(roles), by_(by) {}

  /// Adds a motion that begins at `from`. `shift` is the vector from work coordinates to the picture's coordinates.
  void wait(const Motion& motion, const ToolPosition& from, Vec3 shift, Stroke stroke, ProgramLine line);
  /// Sets the number (CellSource::motion) of the motion added last, and the approximate total length of its cells, mm. Must be called
  /// before those cells arrive.
  void set_motion(std::uint64_t number, double way) {
    waiting_.back().number = number;
    waiting_.back().way = way;
  }
  /// Moves the waiting motions, and their parts already drawn, by this vector in the picture.
  void move_all(Vec3 by);

  void take(const TimedCells& cells, const MotionLimits& limits, PlotPath& path);
  /// Draws the rest of the waiting motions: rounding errors in the lengths of cells may leave a remainder.
  void finish(PlotPath& path);

 private:
  /// A waiting motion. It stores its start position, since the machine is elsewhere when the cells arrive.
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
  double gone_ = 0;   // mm of the first waiting motion that the received cells cover
  double drawn_ = 0;  // fraction of the first waiting motion that is drawn
  PlotPoint held_{};  // last point, not added to the path yet, since the next point may replace it
  bool holds_ = false;
};

/// Maps shades to colours, in the intervals of a scale.
class ShadeScale {
 public:
  /// Builds a scale that covers the cutting motions of the path.
  ShadeScale(PlotColour by, const PlotPath& path);

  PlotColour by() const { return by_; }
  std::size_t steps() const;
  std::size_t step_of(float shade) const;
  Colour ink(std::size_t step) const;
  /// True if some stroke of the path has the colour of this interval.
  bool occurs(std::size_t step) const { return (occurs_ >> step & 1U) != 0; }
  /// The greatest speed on the scale, mm/min.
  double top() const { return top_; }

 private:
  PlotColour by_;
  double top_ = 1;
  std::uint32_t occurs_ = 0;
};

}  // namespace kadr
