// Plans a program and collects the planner's cells (short segments of the timed path), divided where the axes are at rest.

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "config/control/control_file.h"
#include "session/session.h"
#include "stretch.h"

namespace kadr::reference {
namespace {

constexpr double standing = 1e-9;       // mm/s; a slower speed counts as rest
constexpr double without_force = 1e-3;  // mm/s²; a smaller acceleration counts as 0

MachineProfile profile_of(const Machine& machine, const std::vector<std::string>& axes) {
  MachineProfile profile;
  for (const std::string& axis : axes) {
    AxisProfile& own = profile.axes[axis];
    own.rapid = machine.speed * 60;
    own.acceleration = machine.acceleration;
    own.jerk = machine.jerk;
  }
  profile.tool_change_s = 0;
  profile.tolerance = machine.tolerance;
  return profile;
}

/// Collects cells into stretches, from rest to rest, as they arrive.
class Collector {
 public:
  void take(const TimedCells& cells) {
    const std::size_t row = cells.axes * TimedCells::terms;
    for (std::size_t k = 0; k < cells.laws.size(); ++k) {
      const TimeLaw& law = cells.laws[k];
      if (!(law.length > 0)) continue;
      if (law.speed(0) < standing) begin(cells.axes);
      Stretch& to = stretches_.back();
      to.cells.laws.push_back(law);
      to.cells.path.insert(to.cells.path.end(), cells.path.begin() + static_cast<std::ptrdiff_t>(k * row),
                           cells.path.begin() + static_cast<std::ptrdiff_t>((k + 1) * row));
      to.feed.push_back(cells.sources[k].feed);
    }
  }
  void begin(std::size_t axes) {
    if (!stretches_.empty()) {
      const TimeLaw& last = stretches_.back().cells.laws.back();
      if (std::fabs(last.a + last.j * (last.by_time ? last.seconds : last.length)) > without_force)
        throw std::runtime_error("the path turns back on itself: the axes stand, but do not rest");
    }
    stretches_.emplace_back().cells.axes = axes;
  }

  std::vector<Stretch>& stretches() { return stretches_; }

 private:
  std::vector<Stretch> stretches_;
};

}  // namespace

Planned planned(const std::string& file, const Machine& machine) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error(file + ": cannot be read");
  static const auto def = std::make_shared<const ControlDef>(*load_control("mach3"));
  const std::vector<std::string> axes = Control(*def, {}, {file, text_source(""), Encoding::utf8}, {}).axes();
  const auto session = std::move(*Session::open({def, profile_of(machine, axes), {}, {file, text_source(text.str()), Encoding::utf8}}));
  Collector collector;
  kadr::Planned& plan = session->plan(session->own());
  plan.on_cells = [&](const TimedCells& cells) { collector.take(cells); };
  if (session->run() != Session::State::ended) throw std::runtime_error(file + ": it stops");
  (void)plan.finish();
  for (const AlarmReport& report : plan.reports(session->control()))
    if (report.alarm.id == AlarmId::plan_unsolved) throw std::runtime_error(file + ": the planner found no speed");
  return {plan.limits(), std::move(collector.stretches())};
}

}  // namespace kadr::reference
