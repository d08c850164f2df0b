#pragma once
// CannedCycleRun: executes a drilling cycle whose steps the control's file lists (CycleRow::steps). Each call executes a part of one
// drilled hole, so that a cycle of any length needs constant memory. All levels are checked before the first motion, so no later motion can
// fail.

#include <cstdint>

#include "action/action.h"
#include "base/result.h"
#include "config/control/control_def.h"
#include "control/state/control_state.h"

namespace kadr {

class BlockContext;
class Emitter;

class CannedCycleRun {
 public:
  bool active() const { return cycle_ != nullptr; }
  void stop() { cycle_ = nullptr; }
  const CycleRow* cycle() const { return cycle_; }
  /// Replaces the row of the cycle by `same`: the same row in another control object with the same definition. Needed when a snapshot is
  /// restored in another control.
  void relink(const CycleRow* same) { cycle_ = job_.cycle = same; }

  /// The levels and positions of the drilled holes of one block. `first`, `second`, `drill`: indices of the two axes of the plane and of
  /// the drilling axis.
  struct Job {
    const CycleRow* cycle = nullptr;
    std::size_t first = 0, second = 1, drill = 2;
    double step_first = 0, step_second = 0;  // distances from one drilled hole to the next in the plane, mm
    Axes hole{};                             // position of the first drilled hole, programmed coordinates
    std::uint32_t holes = 1;
    // Coordinates on the drilling axis, mm: R, bottom (Z), and the level to which the tool retracts.
    double level = 0, bottom = 0, clear = 0;
    double peck = 0, dwell = 0;
    // G87: shift in the plane, mm, and coordinate of the face that is cut from below, mm.
    double shift_first = 0, shift_second = 0, back_face = 0;
    double return_level = 0;       // L83: coordinate to which the tool retracts at rapid between pecks, mm
    bool preliminary = true;       // the tool first rises at rapid to R if it is below R
    bool pass_from_level = false;  // L83: the tool moves at rapid to the level where each peck begins
  };
  void start(const BlockContext& m, const Job& job);
  /// Returns the coordinate on the drilling axis to which the tool retracts: the initial level, from which it comes, or R (G98, G99).
  static double clear_level(const BlockContext& m, const Job& job);
  /// Returns true if a next block that only states another position in the plane repeats the cycle there without any other change.
  bool repeats(const BlockContext& m) const;
  /// Starts the last cycle again. `to`: position in the plane, programmed coordinates.
  void repeat_at(const BlockContext& m, const Axes& to);

  /// Emits the next actions: as many as fit into the batch, or only a few if run() returns the actions of each block separately.
  Status next(Emitter& m);

 private:
  Status go_on(Emitter& m);
  Status begin_hole(Emitter& m);
  Status step(Emitter& m);
  Status peck(Emitter& m, bool full);
  Status passes(Emitter& m);
  Status drill_to(Emitter& m, MotionKind kind, double level);
  Status plane_to(Emitter& m, double first, double second);
  Status line(Emitter& m, MotionKind kind, AxisMask named);

  const CycleRow* cycle_ = nullptr;
  Job job_;
  SpindleDir spindle_ = SpindleDir::stop;
  std::uint32_t hole_ = 0;
  std::size_t step_ = 0;
  std::uint32_t part_ = 0;  // number of the motion within a peck
  double depth_ = 0;        // coordinate on the drilling axis to which the pecks so far have drilled, mm
  bool in_hole_ = false;
  bool taps_ = false;
  HoleWork work_ = HoleWork::none;
  bool plain_ = false;  // no transformation is active, so a motion along one axis changes only the coordinate of this axis
};

}  // namespace kadr
