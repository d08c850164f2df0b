#pragma once
// Colours a path by its speed, or by what limits the speed (kadr run --colour). A motion waits until the least-time planner has sent its
// cells (short timed segments). Then the motion is drawn in segments, each with its own shade. The number of waiting motions is limited,
// since the planner looks ahead only a limited distance.

#include <deque>

#include "action/step.h"
#include "action/tool_position.h"
#include "kinematics/chain.h"
#include "motion/look_ahead/limited_by.h"
#include "out/picture/plot/plot_path.h"

namespace kadr {

struct Colour;

/// The meaning of the colours of a path. PlotPoint::shade is the speed in mm/min for `speed`, and the number of the enum value Limit for
/// `limit`.
enum class PlotColour : std::uint8_t { stroke, speed, limit };

class ShadedMotions {
 public:
  ShadedMotions(const AxisRoles& roles, PlotColour by) : roles_(roles), chain_(roles), by_(by) {}

  /// Adds a motion that begins at `from`. `shift`: vector from the work coordinates to the coordinates of the picture, mm.
  void wait(const Motion& motion, const ToolPosition& from, Vec3 shift, Stroke stroke, ProgramLine line);
  /// Sets the number (CellSource::motion) of the motion added last, and the approximate total length of its cells, mm. This function must
  /// be called before those cells arrive.
  void set_motion(std::uint64_t number, double distance) {
    waiting_.back().number = number;
    waiting_.back().distance = distance;
  }
  /// Moves the waiting motions by this vector in the picture, including their parts that are already drawn.
  void move_all(Vec3 by);

  void take(const TimedCells& cells, const MotionLimits& limits, PlotPath& path);
  /// Draws the rest of the waiting motions. Rounding errors in the lengths of the cells may have left a rest.
  void finish(PlotPath& path);

 private:
  /// A motion that waits for its cells. It stores its start position, since the machine is elsewhere when the cells arrive.
  struct Waiting {
    Motion motion;
    ToolPosition from;
    Vec3 shift;
    Stroke stroke;
    ProgramLine line;
    std::uint64_t number;
    double distance;
  };
  void draw_to(double distance, float shade, PlotPath& path);
  void draw_rest(float shade, PlotPath& path);
  void draw_part(const Waiting& motion, double from, double to, float shade, PlotPath& path);
  void keep(PlotPoint point, bool may_replace, PlotPath& path);
  void let_go(PlotPath& path);

  AxisRoles roles_;
  Chain chain_;
  PlotColour by_;
  std::deque<Waiting> waiting_;
  double gone_ = 0;   // length of the first waiting motion that the received cells cover, mm
  double drawn_ = 0;  // fraction (0 to 1) of the first waiting motion that is drawn
  PlotPoint held_{};  // the last point, which is not added to the path yet, since the next point may replace it
  bool holds_ = false;
};

/// Converts shades to colours. The scale is divided into intervals of equal colour.
class ShadeScale {
 public:
  /// Creates a scale for the shades of the path's cutting motions.
  ShadeScale(PlotColour by, const PlotPath& path);

  PlotColour by() const { return by_; }
  std::size_t steps() const;
  std::size_t step_of(float shade) const;
  Colour ink(std::size_t step) const;
  /// True if some stroke of the path has the colour of this interval of the scale.
  bool occurs(std::size_t step) const { return (occurs_ >> step & 1U) != 0; }
  /// Returns the greatest speed on the scale, mm/min.
  double top() const { return top_; }

 private:
  PlotColour by_;
  double top_ = 1;
  std::uint32_t occurs_ = 0;
};

}  // namespace kadr
