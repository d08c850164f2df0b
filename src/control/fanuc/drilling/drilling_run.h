#pragma once
// Runs a drilling cycle one operation at a time (spec/nct/18.0, 18.1). One repetition of the cycle drills one hole. The memory needed
// depends neither on the number of repetitions (word L) nor on the depth.

#include <cstddef>
#include <cstdint>

#include "base/code_literals.h"
#include "base/result.h"
#include "config/control/drill_steps.h"
#include "control/emitter.h"

namespace kadr::fanuc {

/// Computes the hole position from the block's axis words, except the word of the drilling axis. `drill`: index of the drilling axis; `to`:
/// the result in programmed coordinates.
///   alarms  those of target() in words/coordinates.h (chapter 5)
Status hole_position(const BlockContext& m, std::size_t drill, Axes& to, AxisMask& named);
/// Executes operation 1 of a drilling cycle (18.0): moves at rapid over the hole. Does nothing if the tool is already over the hole.
Status over_hole(Emitter& m, std::size_t drill);
/// Returns the spindle speed in rev/min that determines the feed of rigid tapping: the programmed speed S of the spindle to which a word
/// referred last.
double tapping_rpm(const BlockContext& m);

/// Executes operations 2 … 10 of the NCT manual (18.0) for the first hole, and operations 1 … 10 for the other holes that word L requests.
/// The run raises no alarm if check_drilling() has succeeded.
class DrillingRun final : public SteppedCycleValue<DrillingRun> {
 public:
  /// The data of one block, from the program and the parameters. Levels are programmed coordinates in mm.
  struct Job {
    std::int32_t code = 0;  // code of the cycle in tenths; if another code stands for the cycle, the code of the cycle itself
    std::size_t axis = 0;   // the drilling axis
    std::uint32_t passes = 1;
    double initial = 0, level = 0, bottom = 0;
    bool to_initial = true;  // true (G98): after the hole the tool returns to the initial level; false (G99): to the R level
    // words Q (depth of a peck) and E (clearance), in mm of machine travel, on which scaling does not act (18.0)
    double peck = 0, clearance = 0;
    double dwell = 0;  // dwell P at the bottom of the hole, in seconds, or in G95 in revolutions of the spindle
    // vector in the plane by which G76 and G87 shift the tool, mm; mirroring, rotation and scaling do not act on it
    Vec2 shift;
    double out_percent = 100;      // feed of the retract from the hole (operation 7) in % of the programmed feed
    double between_percent = 100;  // feed of a tap's return to R between pecks, in % of the programmed feed
    bool back_boring = false;      // back boring: G87 with a spindle that can be oriented
    // PTC=1: between pecks a tap returns to R, as G83 does; false: it returns by a short distance, as G73 does
    bool pecks_to_level = false;
    // hole positions of a pattern, programmed coordinates in mm; empty if the words of the block give the position
    std::vector<Vec2> points;
    double less = 0, least = 0;  // each peck is shorter by `less` than the previous one, but not shorter than `least`, mm (spec/haas 8.3)
    double rise = 0;             // height in mm above R to which the tool returns between pecks
    double clear_after = 0;      // depth in mm that the pecks cut before the tool returns to R (spec/haas 8.3); 0: the tool never returns
    bool orients_tap = false;    // parameter bit TSC = 1: M19 orients the spindle before rigid tapping
    // M code that clamps the C axis over each hole; the next M code releases it after the hole, and the dwell in s follows (spec/fanuc-t
    // 10.1); 0: none. Over the first hole the block's own M word clamps.
    std::uint32_t clamp_code = 0;
    double release_dwell = 0;
  };
  explicit DrillingRun(Job job);

  /// Checks that the spindle turns as the cycle needs, after the block's S and M codes. alarms spindle_not_turning
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
  bool is_tap() const { return job_.code == 84.2_g || job_.code == 84.3_g; }  // rigid tapping, in which spindle and axis are synchronised
  bool taps() const { return is_tap() || job_.code == 84_g || job_.code == 74_g; }
  double down() const { return job_.bottom < job_.level ? -1 : 1; }
  double scale(const BlockContext& m) const;
  double next_depth(const BlockContext& m) const;
  double back_to(const BlockContext& m) const;

  Job job_;
  const DrillCycle& cycle_;
  double peck_ = 0;  // depth of the next peck, mm
  Axes hole_{};
  std::uint32_t pass_ = 0;
  std::size_t at_ = 0;      // index of the next step of the drilling cycle; 0: operation 1
  std::uint32_t part_ = 0;  // phase within a peck: 1 return to the R level, 2 motion to the start of the next cut, other values: cut
  double depth_ = 0;        // level that the pecks have reached, programmed coordinate in mm
  double cut_ = 0;          // depth cut since the last return to R, mm
  bool stands_off_ = false;
};

}  // namespace kadr::fanuc
