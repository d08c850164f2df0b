#pragma once
// The dialect of Grbl 1.1 (spec/grbl; gcode.c, protocol.c, jog.c of Grbl's source). A block is first checked as a whole, in the order of
// Grbl's source. Then all of the block is executed, or nothing.

#include <array>
#include <cstdint>
#include <memory>

#include "control/dialect.h"
#include "control/grbl/block_check.h"

namespace kadr::grbl {

/// The settings $x of Grbl that change what a program does (spec/grbl 10).
struct Settings {
  bool soft_limits = false;         // setting $20: soft limits are checked
  bool homing = false;              // setting $22: homing is enabled
  double max_spindle_speed = 1000;  // setting $30: greatest spindle speed, rev/min
  double min_spindle_speed = 0;     // setting $31: least spindle speed, rev/min
  double arc_tolerance = 0.002;     // setting $12: arc tolerance, mm
  Axes travel{};                    // settings $130 to $132: travel of the axes, mm
};

/// The state that a block changes. An alarm in the block restores it.
struct State {
  double length = 0;  // tool length set by G43.1, mm
  Settings settings;
  Float32State float32_state;
};

class Grbl final : public Dialect {
 public:
  explicit Grbl(const Setup& setup);

  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;
  bool start(Interpreter& m, const Setup& setup) override;
  bool starts_code_by_code() const override { return true; }
  void started(Emitter& m) override;
  Result<bool> statement(Interpreter& m) override;
  Result<bool> takes_block(Interpreter& m) override;
  void begin_block(Emitter& m) override;
  void undo_block(BlockContext& m) override;
  BlockChanges changes_of(const BlockContext& m, const Plan& plan) const override;
  std::int16_t motion_row(const BlockContext& m) const override;
  bool end_program(Interpreter& m) override;
  Status after_block(Interpreter& m) override;
  bool lines_follow(const BlockContext& m) const override;
  void note_line(BlockContext& m) override;
  ArcRule arc_rule(const BlockContext& m) const override;
  Status arc(Emitter& m, const Call& call, Turn turn) override;
  void refresh_frames(Emitter& m) override;
  Status accept_answer(Emitter& m, const ProbeAnswer& answer) override;
  Status machine_code(Interpreter& m, const Call& call) override;

  State state;
  CheckedBlock checked;  // result of checking the block being executed

 private:
  Status jog(Emitter& m);
  void watch_speed(Emitter& m);
  State before_;
  double speed_reported_ = 0;  // speed in the last warning of watch_speed(), rev/min
  double feed_at_end_ = -1;    // feed that remains in force after a block with M2 or M30; -1: the block has neither of them
};

Grbl& grbl_of(const BlockContext& m);

/// Executes a line `$x=v` of the program, which changes a setting (spec/grbl 10).
///   returns  false if Kadr does not use this setting
///   alarms   value_below_zero, step_pulse_short, soft_limits_need_homing
Result<bool> set(Settings& settings, int number, double value, Span where);

}  // namespace kadr::grbl
