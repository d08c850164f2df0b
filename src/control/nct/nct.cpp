// The NCT control at power-on, when it reads a set-up, and at the end of a program (spec/nct/12, 20), and how the class Nct saves and
// restores its state for alarms and snapshots. Used by the rest of control.

#include "control/nct/nct.h"

#include <utility>

#include "control/interpreter.h"
#include "control/nct/waiting.h"

namespace kadr::nct {
namespace {

/// Returns the sizes of the tool tables, which the parameters N1400, N2902 and N2903 give.
ToolLimits tool_limits(const ParameterStore& p) {
  const ToolLimits usual;
  const auto whole = [&](const char* name, int otherwise) {
    const ParameterId id = p.named(name);
    return id == ParameterId::none ? otherwise : static_cast<int>(p.value(id));
  };
  const int columns = whole("2903", usual.user_data);
  return {whole("2902", usual.rows), columns > 0 ? columns : usual.user_data, whole("1400", usual.offsets)};
}

/// Returns the number of axes in all channels.
int axes_of_machine(const BlockContext& m, const Setup& setup) {
  int axes = static_cast<int>(m.axis_count);
  constexpr int by_default = 3;  // a channel that lists no axes has the axes X, Y, Z
  for (const auto& [number, channel] : setup.channels) axes += channel.axes.empty() ? by_default : static_cast<int>(channel.axes.size());
  return axes;
}

}  // namespace

Nct::Nct(BlockContext& m, const Setup& setup, const RunLimits& limits, std::shared_ptr<Commons> commons)
    : Fanuc(m, setup, limits, std::move(commons)) {
  tools = ToolManagement(setup, tool_limits(parameters));
  tools.keep_in(m.journal);
  m.waiting.known = channels_of(setup);
}

Nct::~Nct() = default;

void Nct::read_parameters(BlockContext& m) {
  tools.set_limits(tool_limits(parameters));
  Fanuc::read_parameters(m);
  settings = nct::read_settings(source_of(parameters));
}

void Nct::take_setup(Emitter& m, const Setup& setup) {
  Fanuc::take_setup(m, setup);
  axes_in_all = axes_of_machine(m, setup);
  if (m.start_fault.empty()) m.start_fault = coupling_fault(m, setup.events);
  watch_tool_time(m);
}

/// Switches the power off and on (23.5): the gearbox ends, and each axis drives its own machine axis again.
bool Nct::lose_power(Interpreter& m) {
  ActionBatch unseen;
  ActionBatch* const batch_before = std::exchange(m.batch, &unseen);
  disengage(m);
  Fanuc::lose_power(m);
  couplings = {};
  following = 0;
  end_drives(m);
  couple_gantries(m);
  m.batch = batch_before;
  tool_magazine = 10;
  return true;
}

/// Makes run() return the actions of each block separately if the life of a tool is counted in time, so that the time of each block is
/// known.
void watch_tool_time(Emitter& m) {
  if (!nct_of(m).tools.counts_time()) return;
  m.reads_clock = m.each_block = nct_of(m).counts_time = true;
}

/// Ends the coupling of the gearbox at a reset, if N1800 #0 RCE is set (20.1.4).
void Nct::end_gear(Emitter& m) {
  if (!parameters.bit(parameters.named("1800"), 0)) return;
  (void)withdraw(m);
  disengage(m);
}

bool Nct::keeps_group(int group) const {
  constexpr int gear_group = 34;
  return group == gear_group && state.gear.on;  // 20.1.4: with RCE=0 a reset keeps the gearbox in force
}

// ---- undoing a faulty block

void Nct::keep_all() {
  if (keeps_nothing()) before_ = state;
  Fanuc::keep_all();
}

void Nct::undo_block(BlockContext& m) {
  if (!keeps_nothing()) state = before_;
  Fanuc::undo_block(m);
}

void Nct::block_undone(Emitter& m) {
  Fanuc::block_undone(m);
  if (m.keeps_state()) follow_from_here(m);
}

// ---- snapshot

NctState::NctState(const Nct& of) : FanucState(of), own(of) {}

std::shared_ptr<const DialectState> Nct::snapshot() const { return std::make_shared<NctState>(*this); }

Status Nct::restore(BlockContext& m, const DialectState& from) {
  KADR_TRY(Fanuc::restore(m, from));
  static_cast<nct::Memory&>(*this) = static_cast<const NctState&>(from).own;
  return {};
}

}  // namespace kadr::nct

namespace kadr {

nct::Nct& nct_of(const BlockContext& m) { return static_cast<nct::Nct&>(*m.dialect); }

}  // namespace kadr
