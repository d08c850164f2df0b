#include "control/control.h"

#include <utility>

#include "config/machine_axes.h"
#include "control/machinery.h"
#include "control/nct/nct.h"
#include "control/shared_memory.h"

namespace kadr {

Control::Control(const ControlDef& def, const Setup& setup, Program program, const RunLimits& limits, std::shared_ptr<SharedMemory> shared)
    : shared_(std::move(shared)) {
  std::unique_ptr<ControlDef> own;
  std::string error;
  if (def.behaviour.machine_axes) {
    own = std::make_unique<ControlDef>(def);
    error = fit_to_machine(*own, setup);
  }
  machinery_ = std::make_unique<Machinery>(def, std::move(own), setup, std::move(program), limits,
                                           shared_ ? shared_->commons : std::make_shared<nct::Commons>());
  if (shared_) shared_->share_offsets(machinery_->tables.offsets, static_cast<int>(setup_number(setup, "1401")));
  if (!error.empty()) machinery_->start_fault = {"axes", error, error};
  machinery_->on_warning = &on_warning;
  machinery_->on_block = &on_block;
  machinery_->on_changes = &on_changes;
}
Control::~Control() = default;

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
  if (!machinery_->nct) return;
  double& signal = machinery_->nct->signals[name];
  if (name == nct::interrupt_signal && signal == 0 && value != 0) machinery_->nct->signal_rose = true;
  signal = value;
  if (on_signal) on_signal(name, value != 0);
  if (nct::waiting_suspended(*machinery_)) machinery_->waiting.meeting.reset();
}
void Control::set_skip(int number, bool on) {
  if (number >= 1 && number < 10) machinery_->skip_switches[static_cast<std::size_t>(number)] = on;
}
void Control::set_answer(double answer) {
  if (machinery_->nct) machinery_->nct->answer = answer;
}
void Control::synchronise(int slave, int master) {
  if (!machinery_->nct) return;
  for (int n = 1; n <= static_cast<int>(nct::most_spindles); ++n) {
    if (slave != n && slave != 0) continue;
    nct::SpindleState& s = machinery_->nct->spindle(n);
    s.master = master;
    if (master < 1 || master > static_cast<int>(nct::most_spindles)) continue;
    nct::SpindleState& leads = machinery_->nct->spindle(master);  // both loops are closed, the slave has the master's speed (nct 11.7.4)
    s.rpm = leads.rpm;
    s.dir = leads.dir;
    s.loop_closed = leads.loop_closed = true;
  }
}
void Control::couple_axes(const std::vector<std::string>& axes, bool on) {
  for (const std::string& name : axes)
    if (machinery_->nct) nct::couple_axis(*machinery_, name, on);
}
void Control::convert_spindle(int number, bool to_axis) {
  if (!machinery_->nct || number < 1 || number > static_cast<int>(nct::most_spindles)) return;
  nct::SpindleState& s = machinery_->nct->spindle(number);
  s.dir = SpindleDir::stop;
  s.master = 0;
  s.loop_closed = to_axis;
  s.referenced = false;
}
void Control::power_cycle() { machinery_->power_cycle(); }
void Control::set_time(double now_ms, double cutting_ms) {
  if (!machinery_->nct) return;
  nct::Nct& nct = *machinery_->nct;
  nct.now_ms = now_ms;
  const double cut = cutting_ms - std::exchange(cutting_seen_ms_, cutting_ms);
  nct.cutting_ms += cut;  // the program may have set it
  constexpr double ms_per_s = 1000;
  if (nct.counts_time) nct.tools.add_time(cut / ms_per_s);
  nct.counts_time = nct.tools.counts_time();
}
bool Control::reads_clock() const { return machinery_->reads_clock; }
std::optional<RunState> Control::run_state() const {
  if (!machinery_->nct) return std::nullopt;
  return machinery_->nct->run_state(*machinery_);
}
std::map<std::uint32_t, std::string> Control::texts_of(const std::set<std::uint32_t>& lines, std::uint16_t file) const {
  return machinery_->flow.file(file).texts_of(lines);
}
std::vector<std::string> Control::files_read() const { return machinery_->flow.paths(); }
const WrittenFiles& Control::files_written() const {
  static const WrittenFiles none;
  return machinery_->nct ? machinery_->nct->output.files() : none;
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
bool Control::has_machine_parameters() const { return machinery_->nct != nullptr; }
std::uint32_t Control::rotary() const { return machinery_->def.rotary; }
const SetupFault& Control::setup_fault() const { return machinery_->start_fault; }

}  // namespace kadr
