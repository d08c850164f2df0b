#pragma once
// AreaMaker: the steps of one call of a milling cycle: pockets, slots, studs, faces, threads, back boring
// (spec/heidenhain 12.4, 12.8, 12.10 to 12.13). Only src/control/heidenhain includes this file.

#include <vector>

#include "control/heidenhain/mill_path.h"

namespace kadr::heidenhain {

/// Returns true if AreaMaker makes the steps of a cycle.
bool is_area_cycle(int cycle);
/// Returns true for an area cycle whose place its parameters give, so that it begins wherever the tool is.
bool has_own_place(int cycle);

/// The area of a pocket: a rectangle with rounded corners, or a slot along a circle about the origin that begins on the X axis.
struct PocketShape {
  RoundedRectangle outer;  // of a slot along a circle: half of its width
  double arc_radius = 0;   // 0: a rectangle
  double arc_degrees = 0;
  Vec2 begin;  // where the tool goes down
};

class AreaMaker {
 public:
  ///   at     where the tool stands in the plane when the cycle begins, programmed coordinates
  ///   steps  the cycle's steps are added to it
  ///   raised  shift of the surface: Z of CYCL CALL POS or of a point of a pattern
  AreaMaker(BlockContext& m, const Heidenhain& own, Span where, Vec2 at, std::vector<CycleStep>& steps, double raised)
      : m_(m), own_(own), where_(where), steps_(steps), plane_(m.modal.axes), at_(at), unit_(m.unit_scale()), raised_(raised) {}

  ///   alarms  pocket_tool_missing, pocket_tool_large, value_out_of_range, feed_missing, cycle_endless, not_available
  Status run(int cycle);

 private:
  static constexpr std::size_t most_steps = 200'000;

  double q(std::size_t index) const { return own_.memory.q[index]; }
  bool given(std::size_t index) const { return own_.memory.given(index); }
  double length_of(std::size_t index) const { return q(index) * unit_; }
  /// Returns a feed in mm/min; below 0: rapid.
  double feed_of(std::size_t index) const { return q(index) * unit_; }

  MillPath new_path() const;
  Status needs_feed() const;
  Status take_common();
  void take_levels();
  static std::vector<double> levels_of(double surface, double bottom, double infeed);
  void leave(MillPath& path) const { path.raise(second_ > clearance_ ? second_ : clearance_); }
  void dwell(double seconds);
  void spindle(SpindleDir dir, double angle = 0);

  // pocket_cycles.cpp
  static void pocket_ring(const PocketShape& shape, double inset, bool clockwise, std::vector<RingMove>& moves);
  void plunge(MillPath& path, const PocketShape& shape, double height);
  void clear(MillPath& path, const PocketShape& shape, double feed);
  void finish_wall(MillPath& path, const PocketShape& shape, double feed);
  Status pocket(MillPath& path, PocketShape shape);
  Status new_pocket(int cycle);
  Status arc_slots(MillPath& path, const PocketShape& shape, int place);
  Status old_finishing_pocket(int cycle);
  Status old_pocket(int cycle);

  // stud_cycles.cpp
  Status stud(int cycle);
  void around_stud(MillPath& path, RoundedRectangle finished, double blank, double feed);
  Status multipass();
  Status ruled_surface();
  Status face();

  // thread_cycles.cpp
  Status thread(int cycle);
  void countersink(MillPath& path, double depth, double offset, double feed);
  void thread_turns(MillPath& path, double radius, double from, double to);
  Status drill_first(MillPath& path);
  Status back_boring();

  BlockContext& m_;
  const Heidenhain& own_;
  Span where_;
  std::vector<CycleStep>& steps_;
  PlaneAxes plane_;
  Vec2 at_;
  double unit_, raised_;

  double radius_ = 0;                                             // of the tool
  double surface_ = 0, clearance_ = 0, second_ = 0, bottom_ = 0;  // Q203, Z1, Z2, the depth
  double infeed_ = 0, finish_infeed_ = 0;                         // 0: all at once
  double feed_ = 0, plunge_feed_ = 0, finish_feed_ = 0;           // mm/min; 0: the feed in force; below 0: rapid
  double side_allowance_ = 0, floor_allowance_ = 0, width_ = 0;
  bool clockwise_ = false;
  int operation_ = 0;  // Q215; 5: the wall alone
  int plunge_kind_ = 0;
};

}  // namespace kadr::heidenhain
