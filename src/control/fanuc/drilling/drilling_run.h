#pragma once
// Runs a drilling cycle one operation at a time (spec/nct/18.0, 18.1). One pass drills one hole. Memory is constant for any number of
// passes (word L) and any depth.

#include <cstddef>
#include <cstdint>

#include "base/code_literals.h"
#include "base/result.h"
#include "config/control/drill_steps.h"
#include "control/emitter.h"

namespace kadr::fanuc {

/// Computes the block's hole position from its axis words, except the word of the drilling axis. `to`: programmed coordinates.
///   alarms  those of target() in words/coordinates.h (chapter 5)
Status hole_position(const BlockContext& m, std::size_t drill, Axes& to, AxisMask& named);
/// Operation 1: moves at rapid over the hole; does nothing if the tool is already there.
Status over_hole(Emitter& m, std::size_t drill);
/// Returns the spindle speed that rigid tapping couples the axis to, rev/min: S of the spindle that a word referred to last.
double tapping_rpm(const BlockContext& m);

/// Runs operations 2 … 10 of the first pass, and all operations of the other passes that L requests. A run cannot fail after
/// check_drilling() has succeeded.
class DrillingRun final : public SteppedCycleValue<DrillingRun> {
 public:
  /// Data of one block from the program and the parameters. Levels are programmed coordinates, mm.
  struct Job {
    std::int32_t code = 0;  // code in tenths; for an alias, the code of the cycle that it stands for
    std::size_t axis = 0;   // the drilling axis
    std::uint32_t passes = 1;
    double initial = 0, level = 0, bottom = 0;
    bool to_initial = true;          // G98: the tool returns to the initial level; else to R
    double peck = 0, clearance = 0;  // mm of machine travel: not scaled (18.0)
    double dwell = 0;                // P, seconds or revolutions
    Vec2 shift;                      // mm in the plane; not mirrored, rotated or scaled
    double out_percent = 100;        // feed of the retract (operation 7), % of the programmed feed
    double between_percent = 100;    // feed of a tap's return to R between its cuts, % of the programmed feed
    bool back_boring = false;        // G87 with a spindle that can be oriented
    bool pecks_to_level = false;     // a tap clears chips at R like G83 (PTC=1), else it breaks them like G73
    std::vector<Vec2> points;        // pattern: hole positions, programmed, one per pass; empty: the block's words give the position
    double less = 0, least = 0;      // each peck is shorter by `less` than the previous one, but at least `least` (spec/haas 8.3)
    double rise = 0;                 // the return between pecks goes to this height above R
    double clear_after = 0;          // after cuts of this total depth the tool returns to R (spec/haas 8.3); 0: never
    bool orients_tap = false;        // TSC=1: the spindle is oriented before tapping
  };
  explicit DrillingRun(Job job);

  /// Checks the spindle speed that the cycle needs, after the block's S and M codes. alarms spindle_not_turning
  Status check(const Emitter& m) const;
  Result<bool> next(Emitter& m) override;
  bool functions_first() const override { return true; }

 private:
  Status begin_pass(Emitter& m);
  Status over_point(Emitter& m, Vec2 point);
  Status step(Emitter& m, DrillStep step);
  Status spindle_step(Emitter& m, DrillStep step);
  Status pecks(Emitter& m, bool to_level);
  Status tap_in(Emitter& m);
  Status close_loop(Emitter& m);
  Status dwell(Emitter& m);
  Status shift(Emitter& m, Vec2 by);
  Status rapid(Emitter& m, double level);
  Status feed(Emitter& m, double level, double percent);
  Status tap(Emitter& m, double level, double percent);
  void single_block(Emitter& m) const;
  bool is_tap() const { return job_.code == 84.2_g || job_.code == 84.3_g; }  // the spindle and the axis are synchronised
  bool taps() const { return is_tap() || job_.code == 84_g || job_.code == 74_g; }
  double down() const { return job_.bottom < job_.level ? -1 : 1; }
  double scale(const BlockContext& m) const;
  double next_depth(const BlockContext& m) const;
  double back_to(const BlockContext& m) const;

  Job job_;
  const DrillCycle& cycle_;
  double peck_ = 0;  // depth of the next peck
  Axes hole_{};
  std::uint32_t pass_ = 0;
  std::size_t at_ = 0;      // next step of the cycle; 0: operation 1
  std::uint32_t part_ = 0;  // phase within a peck: 1 return to R, 2 move to the start of the next cut, else cut
  double depth_ = 0;        // level reached by pecks, programmed coordinate, mm
  double cut_ = 0;          // depth cut since the last return to R, mm
  bool stands_off_ = false;
};

}  // namespace kadr::fanuc
