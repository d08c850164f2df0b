#pragma once
// Drilling cycles by steps (CycleRow::steps): a hole at a time, an action at a time, so that a cycle of any length runs
// in constant memory. Levels are checked before the first motion; nothing fails after it.

#include <cstdint>

#include "action/action.h"
#include "base/result.h"
#include "config/control_def.h"
#include "control/state/state.h"

namespace kadr {

class BlockContext;
class Emitter;

class CycleRun {
 public:
  bool active() const { return cycle_ != nullptr; }
  void stop() { cycle_ = nullptr; }
  const CycleRow* cycle() const { return cycle_; }
  /// The same row in the table of another control of the same kind.
  void lead_to(const CycleRow* same) { cycle_ = job_.cycle = same; }

  /// Levels and holes of one block. Axes by index: first and second in the plane, drilling axis.
  struct Job {
    const CycleRow* cycle = nullptr;
    std::size_t first = 0, second = 1, drill = 2;
    double step_first = 0, step_second = 0;  // from hole to hole, mm
    Axes hole{};                             // programmed, of the first hole
    std::uint32_t holes = 1;
    double level = 0, bottom = 0, clear = 0;  // R, Z, and where each hole ends
    double peck = 0, dwell = 0;
    double shift_first = 0, shift_second = 0, back_face = 0;  // G87
    double return_level = 0;                                  // L83: rapid here between passes
    bool preliminary = true;                                  // up to R before the first hole if below it
    bool pass_from_level = false;                             // L83: rapid to the level a pass begins at
  };
  void start(const BlockContext& m, const Job& job);

  /// Emits the next actions, as many as the batch has room for; a few at a time where each block is handed over.
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
  std::uint32_t part_ = 0;  // within pecks
  double depth_ = 0;        // reached by pecks
  bool in_hole_ = false;
  bool taps_ = false;
  HoleWork work_ = HoleWork::none;
  bool plain_ = false;  // a motion of one axis changes nothing else
};

}  // namespace kadr
