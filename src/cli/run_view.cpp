// For cli/run.

#include "cli/run_view.h"

#include <algorithm>

namespace kadr::cli {

View::View(const Channel& channel, const Rates& rates) : statistics(channel.control->axes(), channel.control->rotary(), rates) {
  statistics.start_with(channel.setup.spindle().rpm, static_cast<std::uint32_t>(std::max(channel.setup.tool, 0)));
}

void View::begin_look_ahead(const Channel& channel, const Rates& rates, const MachineProfile& profile) {
  const Control& control = *channel.control;
  SpeedRules rules = speed_rules(channel.setup, control.axes(), profile);
  if (control.has_machine_parameters()) obey_parameters(rules, channel.setup, control.axes());
  else rules.blend = profile.tolerance;  // INFERRED: of all that state no limit at corners
  if (!rules.in_force) return;
  statistics.count_by(rules.accelerates() ? TimeBasis::accelerated : TimeBasis::limited);
  look_ahead.emplace(AxisRoles::of(control.axes(), control.rotary()), rules, rates.rapid, [this](const Step& step, double longer) {
    if (const Motion* const motion = step.motion()) statistics.lengthen(*motion, longer);
    if (trace) trace->write(step);
  });
}

void View::show(const Step& step) {
  const bool is_motion = step.motion() != nullptr;
  if (is_motion) statistics.consume(step);
  if (look_ahead) look_ahead->consume(step);
  else if (trace) trace->write(step);
  if (!is_motion) statistics.consume(step);
}

void View::look(const Step& step) {
  if (plot) plot->consume(step);
  if (planned) planned->consume(step);
}

std::function<void(const Action&)> View::programmed() {
  if (!plot) return {};
  return [this](const Action& action) { plot->take_programmed(action); };
}

}  // namespace kadr::cli
