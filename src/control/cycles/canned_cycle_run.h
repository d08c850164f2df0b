#pragma once
// CannedCycleRun: executes a drilling cycle that is given by steps (CycleRow::steps), one drilled hole and one action at a time, so that a
// cycle of any length runs in constant memory. Levels are checked before the first motion; nothing fails after it.

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
  /// Continues with the row `same`, which is the same row in the table of another control with the same definition.
  void lead_to(const CycleRow* same) { cycle_ = job_.cycle = same; }

  /// Levels and positions of one block. Axes are given by index: first and second axis of the plane, drilling axis.
  struct Job {
    const CycleRow* cycle = nullptr;
    std::size_t first = 0, second = 1, drill = 2;
    double step_first = 0, step_second = 0;  // from one drilled hole to the next, mm
    Axes hole{};                             // first drilled hole, programmed coordinates
    std::uint32_t holes = 1;
    double level = 0, bottom = 0, clear = 0;  // R, Z, and the level to which the tool retracts from each drilled hole
    double peck = 0, dwell = 0;
    double shift_first = 0, shift_second = 0, back_face = 0;  // G87
    double return_level = 0;                                  // L83: level to which the tool retracts between pecks, at rapid
    bool preliminary = true;                                  // rapid up to R before the first drilled hole if the tool is below it
    bool pass_from_level = false;                             // L83: rapid to the level where a peck begins
  };
  void start(const BlockContext& m, const Job& job);

  /// Emits the next actions, as many as fit into the batch; only a few if each block is passed on separately.
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
  double depth_ = 0;        // depth reached by pecks
  bool in_hole_ = false;
  bool taps_ = false;
  HoleWork work_ = HoleWork::none;
  bool plain_ = false;  // a motion along one axis changes nothing but the position
};

}  // namespace kadr
