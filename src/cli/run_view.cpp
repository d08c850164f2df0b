// View: observes one channel of a run. It is used by cli/run.

#include "cli/run_view.h"

#include <algorithm>

namespace kadr::cli {

View::View(const Channel& channel, const Rates& rates) : statistics(channel.control->axes(), channel.control->rotary(), rates) {
  statistics.start_with(channel.setup);
}

void View::show(const Step& step) {
  statistics.consume(step);
  if (plot) plot->consume(step);
}

void View::show_timed(const Step& step, double longer) {
  if (const Motion* const motion = step.motion(); motion != nullptr && longer != 0) statistics.lengthen(*motion, longer);
  if (trace) trace->write(step);
}

std::function<void(const Action&)> View::programmed() {
  if (!plot) return {};
  return [this](const Action& action) { plot->follow_programmed(action); };
}

}  // namespace kadr::cli
