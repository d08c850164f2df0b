// Planned: plans the motion of one channel's axes in time with the least-time planner (docs/planner.md). It is used by cli/run_view.

#include "session/planned.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include "motion/time/estimate.h"
#include "out/text/lost_time_text.h"

namespace kadr {

Planned::Planned(const Channel& channel, const MachineProfile& profile, const ToolPosition& stand, StopToken stop)
    : stop_(stop),
      axes_(channel.control->axes()),
      roles_(AxisRoles::of(axes_, channel.control->rotary())),
      limits_(motion_limits(profile, channel.setup, axes_)),
      motion_(roles_, limits_, profile.tolerance, stand, [this](const TimedCells& cells) { see(cells); }) {
  motion_.stop_by(stop);
  motion_.start(channel.setup, axes_, rates_of(profile, channel.setup, axes_).most_rpm);
}

void Planned::write_samples(std::FILE* file, SampleOptions options) {
  max_time_ = options.max_time;
  options.stop = stop_;
  writer_.emplace(file, axes_, limits_, std::move(options));
}

void Planned::write_tips(std::FILE* file) {
  writer_->write_tips(file, roles_);
  motion_.on_place = [this](std::uint64_t motion, const ToolPosition& from) { writer_->take_place(motion, from); };
}

Planned::Memory Planned::memory() {
  motion_.settle();
  return {motion_.snapshot(), time_, writer_ ? std::optional(writer_->memory()) : std::nullopt};
}

void Planned::resume_from(const Memory& memory) {
  motion_.restore(memory.motion);
  time_ = memory.time;
  if (writer_ && memory.samples) writer_->resume_from(*memory.samples);
}

void Planned::colour(Plot& plot) {
  coloured_ = &plot;
  motion_.on_motion = [&plot](std::uint64_t number, double length) { plot.shaded().set_motion(number, length); };
}

void Planned::see(const TimedCells& cells) {
  time_.take(cells, limits_);
  if (writer_) writer_->take(cells);
  if (on_cells) on_cells(cells);
  if (lost_time_) lost_time_->take(cells);
  if (record_) record_->take(cells);
  if (coloured_ != nullptr) coloured_->take(cells, limits_);
  if (ends_with_samples_ && writer_->ended() == SampleEnd::max_time) motion_.end_here();
}

bool Planned::finish() {
  motion_.finish();
  if (coloured_ != nullptr) coloured_->finish_cells();
  if (!writer_) return true;
  writer_->finish();
  return writer_->ok();
}

bool Planned::stopped() const { return motion_.ended() == PlanEnd::stopped || (writer_ && writer_->ended() == SampleEnd::stopped); }

AlarmReport Planned::report(const Control& control, const Alarm& alarm, const Spent& at) {
  AlarmReport report{alarm, control.file_name(at.file), {}, {}, {}};
  report.origin.line = at.line;
  report.origin.column = 1;
  report.origin.file = at.file;
  for (auto& [line, text] : control.texts_of({at.line}, at.file)) report.line_text = text;
  report.alarm.where.end = static_cast<std::uint32_t>(report.line_text.size());
  return report;
}

std::vector<AlarmReport> Planned::reports(const Control& control) const {
  constexpr double percent = 100;
  std::vector<AlarmReport> reports;
  const PlanFaults& faults = motion_.faults();
  if (faults.unsolved > 0)
    reports.push_back(report(control, warning(AlarmId::plan_unsolved, {}, static_cast<double>(faults.unsolved), faults.unsolved_length),
                             faults.unsolved_at));
  if (faults.beyond > 0) {
    const double part = std::ceil(percent * faults.beyond);
    reports.push_back(report(control, warning(AlarmId::plan_tolerance, {}, part), faults.beyond_at));
  }
  if (motion_.ended() == PlanEnd::too_slow) {
    const AxisMotion::Refused refused = motion_.refused();
    reports.push_back(report(control, alarm(AlarmId::plan_endless, {}, refused.length, Planner::most_of_standing), refused.at));
  }
  if (writer_ && writer_->ended() == SampleEnd::max_time)
    reports.push_back(report(control, alarm(AlarmId::samples_too_long, {}, max_time_), Spent::of(writer_->tag())));
  return reports;
}

std::string Planned::why(const Control& control, Lang lang) const {
  if (time() == nullptr) return {};
  constexpr std::size_t rows_shown = 10;
  std::vector<LostTimeRow> rows;
  std::map<std::uint16_t, std::set<std::uint32_t>> lines;
  for (const LostTime::Place& place : lost_time_->worst(rows_shown)) {
    lines[place.file].insert(place.line);
    rows.push_back({place, place.file == 0 ? "" : std::filesystem::path(control.file_name(place.file)).filename().string(), ""});
  }
  for (const auto& [file, needed_lines] : lines)
    for (const auto& [line, text] : control.texts_of(needed_lines, file))
      for (LostTimeRow& row : rows)
        if (row.place.file == file && row.place.line == line) row.block = text;
  return lost_time_text(rows, lost_time_->all(), axes_, lang);
}

}  // namespace kadr
