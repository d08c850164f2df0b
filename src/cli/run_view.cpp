// For cli/run.

#include "cli/run_view.h"

#include <algorithm>

namespace kadr::cli {

View::View(const Channel& channel, const Rates& rates, const ToolPosition& stand)
    : statistics(channel.control->axes(), channel.control->rotary(), rates, stand) {
  statistics.start_with(channel.setup.spindle().rpm, static_cast<std::uint32_t>(std::max(channel.setup.tool, 0)));
}

void View::begin_look_ahead(const Channel& channel, const Rates& rates, const ToolPosition& stand, const MachineProfile& profile) {
  const Control& control = *channel.control;
  SpeedRules rules = speed_rules(channel.setup, control.axes(), profile);
  if (control.has_machine_parameters()) obey_parameters(rules, channel.setup, control.axes());
  else rules.blend = profile.tolerance;  // INFERRED: of all that state no limit at corners
  if (!rules.in_force) return;
  statistics.count_by(rules.accelerates() ? TimeBasis::accelerated : TimeBasis::limited);
  look_ahead.emplace(AxisRoles::of(control.axes(), control.rotary()), rules, rates.rapid, stand,
                     [this](const Action& action, const MotionTime& time, double longer) {
                       if (const auto* const motion = std::get_if<Motion>(&action.what)) statistics.lengthen(*motion, longer);
                       if (trace) trace->write(action, time);
                     });
}

void View::show(const Action& action) {
  const bool is_motion = std::holds_alternative<Motion>(action.what);
  const MotionTime time = is_motion ? statistics.take(action) : MotionTime();
  if (look_ahead) look_ahead->take(action, time);
  else if (trace) trace->write(action, time);
  if (!is_motion) statistics.take(action);
}

void View::look(const Action& action) {
  if (plot) plot->take(action);
  if (planned) planned->take(action);
}

std::function<void(const Action&)> View::programmed() {
  if (!plot) return {};
  return [this](const Action& action) { plot->take_programmed(action); };
}

}  // namespace kadr::cli
