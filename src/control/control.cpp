#include "control/control.h"

#include "config/machine_axes.h"
#include "control/machinery.h"
#include "control/nct/nct.h"
#include "control/shared_memory.h"

namespace kadr {

Control::Control(const ControlDef& def, const Setup& setup, Program program, RunLimits limits, std::shared_ptr<SharedMemory> shared) {
  std::unique_ptr<ControlDef> own;
  std::string error;
  if (def.behaviour.machine_axes) {
    own = std::make_unique<ControlDef>(def);
    error = fit_to_machine(*own, setup);
  }
  machinery_ = std::make_unique<Machinery>(def, std::move(own), setup, std::move(program), limits,
                                           shared ? shared->commons : std::make_shared<nct::Commons>());
  if (!error.empty()) machinery_->start_error = error;
  machinery_->on_warning = &on_warning;
  machinery_->on_block = &on_block;
  machinery_->on_changes = &on_changes;
}
Control::~Control() = default;

Control::State Control::run(ActionBatch& batch) { return machinery_->run(batch); }
void Control::answer(const ProbeAnswer& answer) { machinery_->answer(answer); }
void Control::hand_over_each_block() { machinery_->each_block = true; }
void Control::refused() { machinery_->refused(); }
bool Control::is_stopped() const { return machinery_->is_stopped(); }
void Control::go_on() { machinery_->go_on(); }
const AlarmReport& Control::report() const { return machinery_->report; }
AlarmReport Control::report_for(const Alarm& alarm, const Origin& origin) const {
  const Block& last = *machinery_->block;
  if (origin.line != last.position.line || machinery_->flow.in_body()) return machinery_->report_of(alarm, origin, {});
  Alarm placed = alarm;  // the block is still in hand
  placed.where = last.where;
  return machinery_->report_of(placed, origin, last.text);
}

void Control::check_uncalled(const std::function<void(const AlarmReport&)>& on_fault) { machinery_->check_uncalled(on_fault); }
void Control::set_signal(const std::string& name, double value) {
  if (machinery_->nct) machinery_->nct->signals[name] = value;
}
void Control::set_skip(int number, bool on) {
  if (number >= 1 && number < 10) machinery_->skip_switches[static_cast<std::size_t>(number)] = on;
}
void Control::set_answer(double answer) {
  if (machinery_->nct) machinery_->nct->answer = answer;
}
void Control::synchronise(int slave, int master) {
  if (machinery_->nct && slave >= 1 && slave <= static_cast<int>(nct::most_spindles)) machinery_->nct->spindle(slave).master = master;
}
void Control::power_cycle() {
  if (machinery_->nct) machinery_->nct->variables.power_off();
}
void Control::set_time(double now_ms, double cutting_ms) {
  if (!machinery_->nct) return;
  machinery_->nct->now_ms = now_ms;
  machinery_->nct->cutting_ms = cutting_ms;
}
std::optional<RunState> Control::run_state() const {
  if (!machinery_->nct) return std::nullopt;
  return machinery_->nct->run_state(*machinery_);
}
Ending Control::ending() const { return machinery_->ending(); }
std::uint64_t Control::blocks() const { return machinery_->flow.blocks(); }
std::uint64_t Control::bytes_read() const { return machinery_->flow.bytes_read(); }
std::uint64_t Control::bytes() const { return machinery_->flow.bytes(); }
Encoding Control::encoding() const { return machinery_->flow.program().encoding(); }
bool Control::encoding_was_guessed() const { return machinery_->flow.program().encoding_was_guessed(); }
const std::vector<std::string>& Control::axes() const { return machinery_->axis_names; }
std::uint32_t Control::rotary() const { return machinery_->def.rotary; }
const std::string& Control::setup_error() const { return machinery_->start_error; }

}  // namespace kadr
