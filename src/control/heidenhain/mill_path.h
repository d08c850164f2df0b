#pragma once
// MillPath: the steps of a milling cycle in coordinates of its own, whose origin and direction the cycle sets (spec/heidenhain 12.6, 12.10
// to 12.13). Only src/control/heidenhain includes this file.

#include <vector>

#include "control/cycles/pocket_rings.h"
#include "control/heidenhain/cycle_steps.h"

namespace kadr::heidenhain {

class MillPath {
 public:
  ///   at      the tool's position in the plane, programmed coordinates
  ///   height  the coordinate of the tool in the tool axis
  MillPath(std::vector<CycleStep>& steps, PlaneAxes plane, Vec2 at, double height)
      : steps_(steps), plane_(plane), at_(at), height_(height) {}

  /// Puts the origin at a point of the plane, and turns the axes by an angle, degrees. The tool does not move.
  void set_frame(Vec2 origin, double degrees) {
    origin_ = origin;
    turn_ = sincos_deg(degrees);
  }

  // Feeds are in mm/min; below 0: rapid. All points are in the coordinates of the frame.
  void raise(double height, double feed = -1);
  void move(Vec2 to, double feed = -1);
  /// Moves in the plane and in the tool axis together.
  void slope(Vec2 to, double height, double feed);
  void arc(Vec2 to, Vec2 centre, double turns, bool clockwise, double feed) { helix(to, height_, centre, turns, clockwise, feed); }
  void helix(Vec2 to, double height, Vec2 centre, double turns, bool clockwise, double feed);
  void follow(const std::vector<RingMove>& moves, bool clockwise, double feed);

  double height() const { return height_; }
  std::size_t size() const { return steps_.size(); }

 private:
  Vec2 placed(Vec2 p) const { return origin_ + Vec2{p.x * turn_.cos - p.y * turn_.sin, p.x * turn_.sin + p.y * turn_.cos}; }
  void add(Vec2 to, double height, double feed);

  std::vector<CycleStep>& steps_;
  PlaneAxes plane_;
  Vec2 at_;
  double height_;
  Vec2 origin_;
  SinCos turn_;
};

}  // namespace kadr::heidenhain
