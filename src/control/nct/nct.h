#pragma once
// The dialect class of the NCT control (spec/nct): the behaviour that the control's file cannot describe and that no other control has.
// Each channel has one object, whose memory is a plain value (memory.h). `settings` and `state` of this class have only the data of the
// NCT; the data that the whole Fanuc family has are in fanuc_of(m).settings and fanuc_of(m).state.

#include <memory>
#include <string>
#include <vector>

#include "control/fanuc/fanuc.h"
#include "control/nct/memory.h"

namespace kadr::nct {

using namespace fanuc;  // unqualified names of fanuc are used because Nct is derived from Fanuc

class Nct : public Fanuc, public nct::Memory {
 public:
  using nct::Memory::settings;
  using nct::Memory::state;

  Nct(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons);
  ~Nct() override;

  // ---- start and end
  void take_setup(Emitter& m, const Setup& setup) override;
  void started(Emitter& m) override;
  bool lose_power(Interpreter& m) override;
  RunState run_state(const Emitter& m) const override;

  // ---- undoing a faulty block
  void keep_all() override;
  void undo_block(BlockContext& m) override;
  void block_undone(Emitter& m) override;

  // ---- snapshot
  std::shared_ptr<const DialectState> snapshot() const override;
  Status restore(BlockContext& m, const DialectState& from) override;

  // ---- tools
  Result<std::uint32_t> offset_meant(char letter, std::uint32_t number) const override;
  Status open_tool_data(BlockContext& m, std::uint32_t l, double p, Span where) override;
  Status tool_line(Emitter& m) override;
  /// Returns the number of the magazine that is the channel's default spindle (N0604; 12.3.2): 10, 20, …
  int spindle_magazine() const { return ToolManagement::main_spindle * std::max(Fanuc::settings.default_spindle, 1); }
  std::uint64_t common_version() const override { return tools.tables_version() + Fanuc::common_version(); }
  void take_common(BlockContext& m, const Dialect& from) override;
  bool consume_touched_tables() override;
  std::optional<double> table_value(Emitter& m, const FoundVariable& variable) const override;
  Result<bool> write_table(Emitter& m, const FoundVariable& variable, double value, Span where) override;

  // ---- input and queries of the machine (machine_interface.cpp)
  void couple_axis(Emitter& m, const std::string& name, AxisLink link, bool on) override;
  const std::vector<CrossChannelAxis>& cross_channel_axes() const override { return couplings.far; }
  void drop_cross_channel(Emitter& m, const CrossChannelAxis& axis) override;
  void move_linked_axis(Emitter& m, std::size_t axis, double machine) override;
  bool may_exchange(const BlockContext& m, std::size_t axis) const override;
  void exchange_cross_channel(std::size_t axis, double machine, bool on) override;
  bool is_parked(std::size_t axis) const override { return (drives.parked >> axis & 1U) != 0; }
  void set_time(double at_ms, double cut_ms) override;
  bool waiting_suspended() const override;

  // ---- functions that the interpreter calls (dialect.cpp)
  bool has_unfinished() const override { return Fanuc::has_unfinished() || !drives.requests.empty(); }
  Result<bool> finish(Interpreter& m) override;
  bool lines_follow(const BlockContext& m) const override { return drives.parked == 0 && Fanuc::lines_follow(m); }
  Status may_move(const BlockContext& m, AxisMask named) const override;
  void note_motion(Emitter& m, Motion& motion) override;
  Status accept_answer(Emitter& m, const ProbeAnswer& at) override;
  Status machine_code(Interpreter& m, const Call& call) override;

 protected:
  void read_parameters(BlockContext& m) override;
  void end_gear(Emitter& m) override;
  bool keeps_group(int group) const override;

 private:
  UndoableState before_;  // the state that keep_all() has saved, so that an alarm can restore it
};

/// The part of a snapshot that belongs to the class Nct.
struct NctState : FanucState {
  explicit NctState(const Nct& of);

  nct::Memory own;
};

/// Ends the coupling of the electronic gearbox, if the gearbox is in force (20.1).
void disengage(Emitter& m);
/// Retracts the tool from the teeth of the workpiece, if the electronic gearbox is in force (20.1.4).
Status withdraw(Emitter& m);
/// Makes run() return the actions of each block separately if the life of a tool is counted in time (12.3.1).
void watch_tool_time(Emitter& m);

}  // namespace kadr::nct

namespace kadr {

/// Returns the dialect object of a control that is an NCT.
nct::Nct& nct_of(const BlockContext& m);

}  // namespace kadr
