#pragma once
// A drilling cycle operation by operation (spec/nct/18.0, 18.1), pass by pass: constant memory for any L and any depth.

#include <cstddef>
#include <cstdint>

#include "base/code_literals.h"
#include "base/result.h"
#include "config/drill_steps.h"
#include "control/emitter.h"

namespace kadr::fanuc {

/// Hole position of the block from where the tool stands: its axis words without that of the drilling axis. `to`: programmed.
///   alarms  those of the coordinates (5)
Status hole_position(const BlockContext& m, std::size_t drill, Axes& to, AxisMask& named);
/// Operation 1: at rapid over the hole; nothing if the tool is there.
Status over_hole(Emitter& m, std::size_t drill);
/// Speed that rigid tapping couples the axis with: S of the spindle referred to last, rev/min.
double tapping_rpm(const BlockContext& m);

/// Operations 2 … 10 of the first pass and all of the others that L asks for. Nothing fails in it that check_drilling has let pass.
class DrillingRun final : public RunningValue<DrillingRun> {
 public:
  /// What the program and the parameters say about one block. Levels: programmed, mm.
  struct Job {
    std::int32_t code = 0;  // ten times the number; of an alias, that of its cycle
    std::size_t axis = 0;   // that drills
    std::uint32_t passes = 1;
    double initial = 0, level = 0, bottom = 0;
    bool to_initial = true;          // G98
    double peck = 0, clearance = 0;  // mm as the machine moves: not scaled (18.0)
    double dwell = 0;                // P
    Vec2 shift;                      // mm in the plane; neither mirrored, turned nor scaled
    double out_percent = 100;        // of the feed in operation 7
    double between_percent = 100;    // … of a tap back to R between its cuts
    bool back_boring = false;        // G87 with a spindle that can be oriented
    bool pecks_to_level = false;     // a tap breaks chips like G83 (PTC=1), else like G73
    std::vector<Vec2> points;        // of a pattern, programmed, one a pass; empty: where the block's words lead
    double less = 0, least = 0;      // each next peck so much less, never below (spec/haas 8.3)
    double rise = 0;                 // above R between pecks
    double clear_after = 0;          // cuts that sum up to so much are followed by a way to R (spec/haas 8.3); 0: none
    bool orients_tap = false;        // TSC=1
  };
  explicit DrillingRun(Job job);

  /// Speeds that it needs, after the block's S and M codes. alarms spindle_not_turning
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
  bool is_tap() const { return job_.code == 84.2_g || job_.code == 84.3_g; }  // the spindle is led with the axis
  bool taps() const { return is_tap() || job_.code == 84_g || job_.code == 74_g; }
  double down() const { return job_.bottom < job_.level ? -1 : 1; }
  double scale(const BlockContext& m) const;
  double next_depth(const BlockContext& m) const;
  double back_to(const BlockContext& m) const;

  Job job_;
  const DrillCycle& cycle_;
  double peck_ = 0;  // the next one
  Axes hole_{};
  std::uint32_t pass_ = 0;
  std::size_t at_ = 0;      // step to come; 0: operation 1
  std::uint32_t part_ = 0;  // within pecks
  double depth_ = 0;        // reached by pecks, programmed
  double cut_ = 0;          // since the way to R, mm
  bool stands_off_ = false;
};

}  // namespace kadr::fanuc
