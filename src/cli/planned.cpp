#include "cli/planned.h"

#include <filesystem>

#include "out/lost_time_text.h"

namespace kadr::cli {

Planned::Planned(const Channel& channel, const Job& job, const ToolPosition& stand)
    : roles_(AxisRoles::of(channel.control->axes(), channel.control->rotary())),
      axes_(channel.control->axes()),
      position_(stand),
      estimate_(roles_, rates_of(job.profile, channel.setup, axes_)),
      limits_(motion_limits(job.profile, channel.setup, axes_)),
      motion_(roles_, limits_, job.profile.tolerance, stand, [this](const TimedCells& cells) { see(cells); }) {
  estimate_.spindle(channel.setup.spindle().rpm);
  motion_.start(channel.setup, axes_);
}

void Planned::write_samples(std::FILE* file, const SampleOptions& options) { writer_.emplace(file, axes_, limits_, options); }

void Planned::colour(Plot& plot) {
  coloured_ = &plot;
  motion_.on_motion = [&plot](std::uint64_t number, double way) { plot.shaded().set_motion(number, way); };
}

void Planned::see(const TimedCells& cells) {
  time_.take(cells, limits_);
  if (writer_) writer_->take(cells);
  if (lost_time_) lost_time_->take(cells);
  if (record_) record_->take(cells);
  if (coloured_ != nullptr) coloured_->take(cells, limits_);
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
  if (coloured_ != nullptr) coloured_->finish_cells();
  if (!writer_) return true;
  writer_->finish();
  return writer_->ok();
}

std::string Planned::why(const Control& control, Lang lang) const {
  constexpr std::size_t rows_shown = 10;
  std::vector<LostTimeRow> rows;
  std::map<std::uint16_t, std::set<std::uint32_t>> lines;
  for (const LostTime::Place& place : lost_time_->worst(rows_shown)) {
    lines[place.file].insert(place.line);
    rows.push_back({place, place.file == 0 ? "" : std::filesystem::path(control.file_name(place.file)).filename().string(), ""});
  }
  for (const auto& [file, wanted] : lines)
    for (const auto& [line, text] : control.texts_of(wanted, file))
      for (LostTimeRow& row : rows)
        if (row.place.file == file && row.place.line == line) row.block = text;
  return lost_time_text(rows, lost_time_->all(), axes_, lang);
}

}  // namespace kadr::cli
