// The entrance to the interpreter. Each call is passed to Interpreter, or to MachineInterface, the part of the dialect that serves the
// machine. Used by cli, control, session.

#include "control/control.h"

#include <utility>

#include "config/machine/machine_axes.h"
#include "config/setup/setup_keys.h"
#include "control/interpreter.h"
#include "control/shared_memory.h"
#include "control/snapshot_content.h"
#include "control/tables_now.h"

namespace kadr {

Control::Control(const ControlDef& def, const Setup& setup, Program program, const RunLimits& limits, std::shared_ptr<SharedMemory> shared)
    : shared_(std::move(shared)) {
  std::unique_ptr<ControlDef> own;
  std::string error;
  if (def.machine_axes() || !setup.parameters.empty()) {
    own = std::make_unique<ControlDef>(def);
    error = fit_to_machine(*own, setup);
  }
  interpreter_ = std::make_unique<Interpreter>(def, std::move(own), setup, std::move(program), limits,
                                               shared_ ? shared_->commons : std::make_shared<Commons>());
  if (shared_) shared_->share_offsets(interpreter_->tables.offsets, static_cast<int>(setup_number(setup, "1401")));
  if (!error.empty()) interpreter_->start_fault = {"axes", error, error};
  interpreter_->on_warning = &on_warning;
  interpreter_->on_block = &on_block;
  interpreter_->on_changes = &on_changes;
  interpreter_->find_corners = &find_corners;
  interpreter_->holds_before = &holds_before;
}
Control::~Control() = default;
MachineInterface* Control::machine_interface() const { return interpreter_->dialect->machine_interface(); }

Control::State Control::run(ActionBatch& batch) {
  if (!shared_) [[likely]]
    return interpreter_->run(batch);
  shared_->lend(interpreter_->tables.offsets);
  const State state = interpreter_->run(batch);
  shared_->undo_block(interpreter_->tables.offsets);
  return state;
}
std::optional<Snapshot> Control::snapshot() const { return interpreter_->snapshot(cutting_seen_ms_); }
Status Control::restore(const Snapshot& from) {
  KADR_TRY(interpreter_->restore(from));
  cutting_seen_ms_ = from.content().cutting_seen_ms;
  if (shared_) shared_->undo_block(interpreter_->tables.offsets);
  return {};
}
void Control::answer(const ProbeAnswer& answer) {
  interpreter_->answer(answer);
  if (shared_) shared_->undo_block(interpreter_->tables.offsets);
}
void Control::return_each_block() { interpreter_->each_block = true; }
bool Control::returns_each_block() const { return interpreter_->each_block; }
void Control::refused() {
  interpreter_->refused();
  release();
}
void Control::set_waiting(Waiting waiting) { interpreter_->waiting.mode = waiting; }
void Control::note_lines(LineMarks* marks, std::uint64_t most) {
  interpreter_->line_marks = marks;
  interpreter_->most_unseen = most;
}
void Control::stand_at(const Axes& machine) { interpreter_->stand_at(machine); }
bool Control::in_block() const { return interpreter_->in_block(); }
void Control::enter(const std::string& line) {
  interpreter_->block = &interpreter_->first_block;  // the previous block may belong to an older entered line, which is destroyed now
  interpreter_->flow.enter(line + "\n");
}
bool Control::in_entered() const { return interpreter_->flow.in_entered(); }
Result<double> Control::evaluate(std::string_view expression) const { return interpreter_->value_of(expression); }
std::vector<AlarmReport::Call> Control::calls() const { return interpreter_->calls(); }
const Origin& Control::origin() const { return interpreter_->origin; }
std::vector<InForce> Control::in_force() const { return interpreter_->in_force(); }
LatheModes Control::lathe_modes() const { return interpreter_->lathe_modes(); }
double Control::machine_unit() const { return interpreter_->dialect->machine_unit(); }
std::size_t Control::plane_normal() const { return interpreter_->modal.axes.normal; }
BlockState Control::state_now() const { return interpreter_->state_now(); }
const std::optional<Control::Meeting>& Control::meeting() const { return interpreter_->waiting.meeting; }
void Control::release() { interpreter_->waiting.meeting.reset(); }
bool Control::is_stopped() const { return interpreter_->is_stopped(); }
void Control::go_on() { interpreter_->go_on(); }
const AlarmReport& Control::report() const { return interpreter_->report; }
AlarmReport Control::report_for(const Alarm& alarm, const Origin& origin) const {
  const Block& last = *interpreter_->block;
  if (origin.line == last.position.line && origin.file == interpreter_->flow.reader() && !interpreter_->flow.in_body()) {
    Alarm placed = alarm;  // the alarm's block is still the current one, so the text of the block is known
    placed.where = last.where;
    AlarmReport report = interpreter_->report_of(placed, origin, last.text);
    if (interpreter_->watches_calls()) report.calls = calls_of(origin);
    return report;
  }
  AlarmReport report = interpreter_->plain_report_of(alarm, origin, {});
  const AlarmReport::Line line = line_at(origin);
  report.file = line.file;
  report.line_text = line.text;
  if (!line.text.empty()) report.alarm.where = line.where;
  if (interpreter_->watches_calls()) report.calls = calls_of(origin);
  interpreter_->dialect->reword(*interpreter_, report);
  return report;
}
AlarmReport::Line Control::line_at(const Origin& origin) const {
  AlarmReport::Line line{origin.line, interpreter_->flow.file(), {}, {}};
  constexpr std::uint16_t bodies = 1;  // file number of the bodies of canned cycles, which are in no file
  if (origin.file == bodies || origin.line == 0 || !interpreter_->flow.has_file(origin.file)) return line;
  line.file = file_name(origin.file);
  line.text = interpreter_->flow.file(origin.file).text_of(origin.line);
  const std::size_t first = line.text.find_first_not_of(" \t"), last = line.text.find_last_not_of(" \t\r");
  if (first != std::string::npos) line.where = {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last + 1)};
  return line;
}

void Control::check_uncalled(const std::function<void(const AlarmReport&)>& on_fault) { interpreter_->check_uncalled(on_fault); }
void Control::set_signal(const std::string& name, double value) {
  MachineInterface* const side = machine_interface();
  if (side == nullptr) return;
  side->set_signal(name, value);
  if (const AxisSignal signal = axis_signal(name); !signal.axis.empty())
    side->couple_axis(*interpreter_, std::string(signal.axis), signal.link, value != 0);
  if (on_signal) on_signal(name, value != 0);
  if (on_cross_channel_axes) on_cross_channel_axes();
  if (side->waiting_suspended()) interpreter_->waiting.meeting.reset();
}
const std::vector<CrossChannelAxis>& Control::cross_channel_axes() const {
  static const std::vector<CrossChannelAxis> none;
  const MachineInterface* const side = machine_interface();
  return side == nullptr ? none : side->cross_channel_axes();
}
void Control::drop_cross_channel(const CrossChannelAxis& axis) {
  if (MachineInterface* const side = machine_interface()) side->drop_cross_channel(*interpreter_, axis);
}
void Control::move_linked_axis(std::size_t axis, double machine) {
  if (MachineInterface* const side = machine_interface()) side->move_linked_axis(*interpreter_, axis, machine);
}
bool Control::may_exchange(std::size_t axis) const {
  const MachineInterface* const side = machine_interface();
  return side != nullptr && side->may_exchange(*interpreter_, axis);
}
void Control::exchange_cross_channel(std::size_t axis, double machine, bool on) {
  if (MachineInterface* const side = machine_interface()) side->exchange_cross_channel(axis, machine, on);
}
bool Control::is_parked(std::size_t axis) const {
  const MachineInterface* const side = machine_interface();
  return side != nullptr && side->is_parked(axis);
}
bool Control::rolls_over(std::size_t axis) const {
  const MachineInterface* const side = machine_interface();
  return side != nullptr && side->rolls_over(axis);
}
int Control::axis_number(std::size_t axis) const { return interpreter_->def.axis_numbers[axis]; }
void Control::set_optional_stop(bool on) { interpreter_->optional_stop_on = on; }
void Control::set_skip(int number, bool on) {
  if (number >= 1 && number < 10) interpreter_->skip_switches[static_cast<std::size_t>(number)] = on;
}
void Control::set_answer(double answer) {
  constexpr double yes = 2;
  if (interpreter_->skips_it) interpreter_->skips_it = answer == yes;
  if (MachineInterface* const side = machine_interface()) side->set_answer(answer);
}
void Control::synchronise(int slave, int master) {
  if (MachineInterface* const side = machine_interface()) side->synchronise(slave, master);
}
std::uint64_t Control::common_version() const { return interpreter_->dialect->common_version(); }
void Control::take_common(const Control& from) { interpreter_->take_common(*from.interpreter_); }
void Control::couple_axes(const std::vector<std::string>& axes, AxisLink link, bool on) {
  for (const std::string& name : axes)
    if (MachineInterface* const side = machine_interface()) side->couple_axis(*interpreter_, name, link, on);
  if (on_cross_channel_axes) on_cross_channel_axes();
}
void Control::convert_spindle(int number, bool to_axis) {
  if (MachineInterface* const side = machine_interface()) side->convert_spindle(number, to_axis);
}
void Control::power_cycle() {
  interpreter_->power_cycle();
  if (on_cross_channel_axes) on_cross_channel_axes();
}
void Control::set_time(double now_ms, double cutting_ms) {
  if (MachineInterface* const side = machine_interface()) side->set_time(now_ms, cutting_ms - std::exchange(cutting_seen_ms_, cutting_ms));
}
bool Control::may_read_clock() const { return interpreter_->def.has_clocks(); }
bool Control::reads_clock() const { return interpreter_->reads_clock; }
std::optional<RunState> Control::run_state() const {
  if (const MachineInterface* const side = machine_interface()) return side->run_state(*interpreter_);
  RunState state;
  state.frame = interpreter_->dialect->programming_frame(*interpreter_);
  if (state.frame.empty()) return std::nullopt;
  state.tables = tables_now();
  return state;
}
Setup Control::tables_now() const { return tables_of(*interpreter_); }
std::map<std::uint32_t, std::string> Control::texts_of(const std::set<std::uint32_t>& lines, std::uint16_t file) const {
  return interpreter_->flow.file(file).texts_of(lines);
}
std::shared_ptr<ByteSource> Control::source_of(std::uint32_t file) const {
  return interpreter_->flow.has_file(file) ? interpreter_->flow.file(std::uint16_t(file)).source() : nullptr;
}
std::vector<std::string> Control::files_read() const { return interpreter_->flow.paths(); }
std::vector<std::uint16_t> Control::called_files() const { return interpreter_->flow.called_files(); }
const WrittenFiles& Control::files_written() const { return interpreter_->dialect->files_written(); }
const std::string& Control::file_name(std::uint16_t file) const { return interpreter_->flow.file(file).path(); }
ToolPosition Control::tool_position() const { return {interpreter_->position.work, interpreter_->position.machine}; }
const Placement& Control::placement() const { return interpreter_->frames; }
FinalState Control::ending() const { return interpreter_->ending(); }
void Control::watch_states() { interpreter_->watch_states(); }
std::optional<BlockState> Control::state_of(const Origin& origin) const { return interpreter_->state_of(origin); }
void Control::watch_calls() { interpreter_->watch_calls(); }
std::vector<AlarmReport::Call> Control::calls_of(const Origin& origin) const { return interpreter_->calls_of(origin); }
std::uint64_t Control::blocks() const { return interpreter_->flow.blocks(); }
std::uint64_t Control::bytes_read() const { return interpreter_->flow.bytes_read(); }
std::uint64_t Control::bytes() const { return interpreter_->flow.bytes(); }
Encoding Control::encoding() const { return interpreter_->flow.program().encoding(); }
bool Control::encoding_was_guessed() const { return interpreter_->flow.program().encoding_was_guessed(); }
const std::vector<std::string>& Control::axes() const { return interpreter_->axis_names; }
const ProgramUse& Control::use() const { return interpreter_->use; }
void Control::watch_use() { interpreter_->use.watch(); }
std::optional<SearchRules> Control::search_rules() const {
  const MachineInterface* const side = machine_interface();
  return side != nullptr ? std::optional(side->search_rules()) : std::nullopt;
}
bool Control::has_machine_parameters() const { return machine_interface() != nullptr; }
bool Control::queues_compensation() const { return interpreter_->def.behaviour.queues_compensation(); }
std::uint32_t Control::rotary() const { return interpreter_->def.rotary; }
std::pair<double, double> Control::limits_by_file(std::size_t axis) const { return interpreter_->dialect->limits_by_file(axis); }
const SetupFault& Control::setup_fault() const { return interpreter_->start_fault; }

}  // namespace kadr
