#pragma once
// MachineInterface: the functions of a control for the machine, its logic and its operator.

#include <string>
#include <vector>

#include "config/state/state_file.h"
#include "control/control.h"
#include "control/state/cross_channel_axis.h"

namespace kadr {

class BlockContext;
class Emitter;
struct SearchRules;

/// The input that a control accepts from the machine, its logic and its operator, and their queries. Only dialects that model the machine's
/// logic and operator have an object of this class (nct 11.7, 11.8, 20.2, 23.1, 23.4).
class MachineInterface {
 public:
  virtual ~MachineInterface() = default;
  virtual void set_signal(const std::string& name, double value) = 0;
  /// Sets the answer to the question of a message box (#3107).
  virtual void set_answer(double answer) = 0;
  /// Makes spindle `slave` follow spindle `master`. If `master` is 0, `slave` stops following; if `slave` is 0, all spindles are meant.
  virtual void synchronise(int slave, int master) = 0;
  virtual void couple_axis(Emitter& m, const std::string& name, AxisLink link, bool on) = 0;
  // ---- axes coupled to axes of other channels: Control has functions of the same names, with descriptions
  virtual const std::vector<CrossChannelAxis>& cross_channel_axes() const = 0;
  virtual void drop_cross_channel(Emitter& m, const CrossChannelAxis& axis) = 0;
  virtual void move_linked_axis(Emitter& m, std::size_t axis, double machine) = 0;
  virtual bool may_exchange(const BlockContext& m, std::size_t axis) const = 0;
  virtual void exchange_cross_channel(std::size_t axis, double machine, bool on) = 0;
  virtual bool is_parked(std::size_t axis) const = 0;
  virtual bool rolls_over(std::size_t axis) const = 0;
  virtual void convert_spindle(int number, bool to_axis) = 0;
  /// Sets the times for the clocks of the program.
  ///   now_ms  time since the start of the run, ms
  ///   cut_ms  time of motions at feed since the last call, ms
  virtual void set_time(double now_ms, double cut_ms) = 0;
  virtual RunState run_state(const Emitter& m) const = 0;
  virtual SearchRules search_rules() const = 0;
  /// Returns true while waiting codes (M codes that synchronise channels) have no effect.
  virtual bool waiting_suspended() const = 0;
};

}  // namespace kadr
