#include "cli/planned.h"

namespace kadr::cli {

Planned::Planned(const Channel& channel, const Job& job, const ToolPosition& stand)
    : roles_(AxisRoles::of(channel.control->axes(), channel.control->rotary())),
      axes_(channel.control->axes()),
      position_(stand),
      estimate_(roles_, rates_of(job.profile, channel.setup, axes_)),
      motion_(roles_, motion_limits(job.profile, channel.setup, axes_), job.profile.tolerance, stand,
              [this](const TimedCells& cells) { see(cells); }) {
  estimate_.spindle(channel.setup.spindle().rpm);
}

void Planned::write_samples(std::FILE* file, double rate) { writer_.emplace(file, axes_, rate); }

void Planned::see(const TimedCells& cells) {
  if (writer_) writer_->take(cells);
}

void Planned::take(const Action& action) {
  const TimeSplit before = estimate_.split();
  MotionTime time;
  if (const auto* const motion = std::get_if<Motion>(&action.what))
    time = estimate_.motion(*motion, Curve(roles_, position_.work, *motion));
  else estimate_.other(action);
  position_.take(action);
  const TimeSplit& now = estimate_.split();
  motion_.take(action, time, now.dwell + now.tool_change - before.dwell - before.tool_change);
}

bool Planned::finish() {
  motion_.finish();
  if (!writer_) return true;
  writer_->finish();
  return writer_->ok();
}

}  // namespace kadr::cli
