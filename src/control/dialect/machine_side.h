#pragma once
// MachineSide: the control seen from the machine, its logic and its operator.

#include <string>
#include <vector>

#include "config/state_file.h"
#include "control/control.h"
#include "control/state/far_axis.h"

namespace kadr {

class BlockContext;
class Emitter;
struct SearchRules;

/// What the machine, its logic and its operator tell a control that can be told it, and ask of it. NCT 11.7, 11.8, 20.2, 23.1, 23.4.
class MachineSide {
 public:
  virtual ~MachineSide() = default;
  virtual void set_signal(const std::string& name, double value) = 0;
  /// To the question of a message (#3107).
  virtual void set_answer(double answer) = 0;
  /// Spindle `slave` follows `master`; 0: no more. `slave` 0: all spindles.
  virtual void synchronise(int slave, int master) = 0;
  virtual void couple_axis(Emitter& m, const std::string& name, AxisLink link, bool on) = 0;
  // ---- axes that hang on those of other channels: Control has the same
  virtual const std::vector<FarAxis>& far_axes() const = 0;
  virtual void drop_far(Emitter& m, const FarAxis& axis) = 0;
  virtual void lead_axis(Emitter& m, std::size_t axis, double machine) = 0;
  virtual bool may_exchange(const BlockContext& m, std::size_t axis) const = 0;
  virtual void exchange_far(std::size_t axis, double machine, bool on) = 0;
  virtual bool is_parked(std::size_t axis) const = 0;
  virtual bool rolls_over(std::size_t axis) const = 0;
  virtual void convert_spindle(int number, bool to_axis) = 0;
  /// ms since the start of the run, and ms at feed since the last call.
  virtual void set_time(double now_ms, double cut_ms) = 0;
  virtual RunState run_state(const Emitter& m) const = 0;
  virtual SearchRules search_rules() const = 0;
  /// Waiting codes have no effect.
  virtual bool waiting_suspended() const = 0;
};

}  // namespace kadr
