#include "control/control.h"

#include <utility>

#include "config/machine_axes.h"
#include "control/machinery.h"
#include "control/shared_memory.h"

namespace kadr {

Control::Control(const ControlDef& def, const Setup& setup, Program program, const RunLimits& limits, std::shared_ptr<SharedMemory> shared)
    : shared_(std::move(shared)) {
  std::unique_ptr<ControlDef> own;
  std::string error;
  if (def.machine_axes()) {
    own = std::make_unique<ControlDef>(def);
    error = fit_to_machine(*own, setup);
  }
  machinery_ = std::make_unique<Machinery>(def, std::move(own), setup, std::move(program), limits,
                                           shared_ ? shared_->commons : std::make_shared<Commons>());
  if (shared_) shared_->share_offsets(machinery_->tables.offsets, static_cast<int>(setup_number(setup, "1401")));
  if (!error.empty()) machinery_->start_fault = {"axes", error, error};
  machinery_->on_warning = &on_warning;
  machinery_->on_block = &on_block;
  machinery_->on_changes = &on_changes;
}
Control::~Control() = default;
MachineSide* Control::machine_side() const { return machinery_->dialect ? machinery_->dialect->machine_side() : nullptr; }

Control::State Control::run(ActionBatch& batch) {
  if (!shared_) [[likely]]
    return machinery_->run(batch);
  shared_->lend(machinery_->tables.offsets);
  const State state = machinery_->run(batch);
  shared_->take_back(machinery_->tables.offsets);
  return state;
}
void Control::answer(const ProbeAnswer& answer) {
  machinery_->answer(answer);
  if (shared_) shared_->take_back(machinery_->tables.offsets);
}
void Control::hand_over_each_block() { machinery_->each_block = true; }
bool Control::hands_over_each_block() const { return machinery_->each_block; }
void Control::refused() {
  machinery_->refused();
  machinery_->block_open = false;
  release();
}
void Control::set_waiting(Waiting waiting) { machinery_->waiting.mode = waiting; }
const std::optional<Control::Meeting>& Control::meeting() const { return machinery_->waiting.meeting; }
void Control::release() { machinery_->waiting.meeting.reset(); }
bool Control::is_stopped() const { return machinery_->is_stopped(); }
void Control::go_on() { machinery_->go_on(); }
const AlarmReport& Control::report() const { return machinery_->report; }
AlarmReport Control::report_for(const Alarm& alarm, const Origin& origin) const {
  const Block& last = *machinery_->block;
  if (origin.line == last.position.line && origin.file == machinery_->flow.reader() && !machinery_->flow.in_body()) {
    Alarm placed = alarm;  // the block is still in hand
    placed.where = last.where;
    return machinery_->report_of(placed, origin, last.text);
  }
  AlarmReport report = machinery_->report_of(alarm, origin, {});
  const AlarmReport::Line line = line_at(origin);
  report.file = line.file;
  report.line_text = line.text;
  if (!line.text.empty()) report.alarm.where = line.where;
  return report;
}
AlarmReport::Line Control::line_at(const Origin& origin) const {
  AlarmReport::Line line{origin.line, machinery_->flow.file(), {}, {}};
  constexpr std::uint16_t bodies = 1;  // of cycles: they stand in no file
  if (origin.file == bodies || origin.line == 0) return line;
  line.file = file_name(origin.file);
  line.text = machinery_->flow.file(origin.file).text_of(origin.line);
  const std::size_t first = line.text.find_first_not_of(" \t"), last = line.text.find_last_not_of(" \t\r");
  if (first != std::string::npos) line.where = {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last + 1)};
  return line;
}

void Control::check_uncalled(const std::function<void(const AlarmReport&)>& on_fault) { machinery_->check_uncalled(on_fault); }
void Control::set_signal(const std::string& name, double value) {
  MachineSide* const side = machine_side();
  if (side == nullptr) return;
  side->set_signal(name, value);
  if (on_signal) on_signal(name, value != 0);
  if (side->waiting_suspended()) machinery_->waiting.meeting.reset();
}
void Control::set_skip(int number, bool on) {
  if (number >= 1 && number < 10) machinery_->skip_switches[static_cast<std::size_t>(number)] = on;
}
void Control::set_answer(double answer) {
  if (MachineSide* const side = machine_side()) side->set_answer(answer);
}
void Control::synchronise(int slave, int master) {
  if (MachineSide* const side = machine_side()) side->synchronise(slave, master);
}
void Control::couple_axes(const std::vector<std::string>& axes, bool on) {
  for (const std::string& name : axes)
    if (MachineSide* const side = machine_side()) side->couple_axis(*machinery_, name, on);
}
void Control::convert_spindle(int number, bool to_axis) {
  if (MachineSide* const side = machine_side()) side->convert_spindle(number, to_axis);
}
void Control::power_cycle() { machinery_->power_cycle(); }
void Control::set_time(double now_ms, double cutting_ms) {
  if (MachineSide* const side = machine_side()) side->set_time(now_ms, cutting_ms - std::exchange(cutting_seen_ms_, cutting_ms));
}
bool Control::reads_clock() const { return machinery_->reads_clock; }
std::optional<RunState> Control::run_state() const {
  const MachineSide* const side = machine_side();
  return side == nullptr ? std::nullopt : std::optional(side->run_state(*machinery_));
}
std::map<std::uint32_t, std::string> Control::texts_of(const std::set<std::uint32_t>& lines, std::uint16_t file) const {
  return machinery_->flow.file(file).texts_of(lines);
}
std::vector<std::string> Control::files_read() const { return machinery_->flow.paths(); }
const WrittenFiles& Control::files_written() const {
  static const WrittenFiles none;
  const MachineSide* const side = machine_side();
  return side == nullptr ? none : side->files_written();
}
const std::string& Control::file_name(std::uint16_t file) const { return machinery_->flow.file(file).path(); }
Ending Control::ending() const { return machinery_->ending(); }
std::uint64_t Control::blocks() const { return machinery_->flow.blocks(); }
std::uint64_t Control::bytes_read() const { return machinery_->flow.bytes_read(); }
std::uint64_t Control::bytes() const { return machinery_->flow.bytes(); }
Encoding Control::encoding() const { return machinery_->flow.program().encoding(); }
bool Control::encoding_was_guessed() const { return machinery_->flow.program().encoding_was_guessed(); }
const std::vector<std::string>& Control::axes() const { return machinery_->axis_names; }
const ProgramUse& Control::use() const { return machinery_->use; }
void Control::watch_use() { machinery_->use.watch(); }
bool Control::has_machine_parameters() const { return machine_side() != nullptr; }
std::uint32_t Control::rotary() const { return machinery_->def.rotary; }
const SetupFault& Control::setup_fault() const { return machinery_->start_fault; }

}  // namespace kadr
