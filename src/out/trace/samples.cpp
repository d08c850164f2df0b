// SampleWriter: writes axis positions at the rate of the servo clock as CSV (docs/commands/run.md). It is used by session/planned and
// tested by tests/out/samples_test.cpp.

#include "out/trace/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <iterator>
#include <utility>

#include "base/tolerance.h"

namespace kadr {

SampleWriter::SampleWriter(std::FILE* file, const std::vector<std::string>& axes, MotionLimits limits, SampleOptions options)
    : file_(file),
      axes_(std::min(axes.size(), max_axes)),
      period_(1 / options.rate),
      decimals_(options.rate <= 2000 ? 9 : 12),
      playback_(std::move(limits), options.rate),
      options_(std::move(options)) {
  text_ = "t";
  for (std::size_t a = 0; a < axes_; ++a) text_ += "," + axes[a];
  text_ += options_.spindle ? ",spindle\n" : "\n";
}

void SampleWriter::write(const double* at) {
  constexpr std::size_t chunk = 1 << 16;
  fmt::format_to(std::back_inserter(text_), "{:.6f}", static_cast<double>(instant_) * period_);
  for (std::size_t a = 0; a < axes_; ++a) fmt::format_to(std::back_inserter(text_), ",{:.{}f}", at[a], decimals_);
  if (options_.spindle) fmt::format_to(std::back_inserter(text_), ",{:.{}f}", playback_.spindle(), decimals_);
  text_ += '\n';
  if (tip_file_ != nullptr) write_tip(at);
  if (text_.size() >= chunk) flush();
}

void SampleWriter::write_tips(std::FILE* file, const AxisRoles& roles) {
  tip_file_ = file;
  roles_ = roles;
  tip_text_ = "t,X,Y,Z,I,J,K\n";
}

void SampleWriter::take_place(std::uint64_t motion, const ToolPosition& from) {
  if (tip_file_ == nullptr) return;
  // Usually the work coordinates and the tool length are the same as on the last motion, so the last ToolPlace still applies.
  if (!places_.empty()) {
    const ToolPosition& last = places_.back().from;
    bool same = last.space == from.space && last.turn == from.turn;
    for (std::size_t a = 0; same && a < axes_ && (!from.space || !from.space->has_rotary()); ++a)
      same = std::fabs((last.machine[a] - last.work[a]) - (from.machine[a] - from.work[a])) <= tol::same_point;
    if (same) return;
  }
  places_.push_back({motion, from});
}

/// Writes the position of the tool tip in work coordinates. If no rotary axes are in use, it is computed from the machine position, the
/// difference between work and machine coordinates, and the rotated frame.
void SampleWriter::write_tip(const double* at) {
  while (places_.size() > 1 && places_[1].motion <= playback_.motion()) places_.pop_front();
  Axes machine{};
  std::copy_n(at, axes_, machine.begin());
  Pose pose;
  if (places_.empty()) return;
  const ToolPosition& from = places_.front().from;
  if (from.space && from.space->has_rotary()) {
    pose = from.space->pose(machine);
  } else {
    Axes work{};
    for (std::size_t a = 0; a < axes_; ++a) work[a] = machine[a] - from.machine[a];
    if (from.turn) work = turned_back_axes(*from.turn, work);
    for (std::size_t a = 0; a < axes_; ++a) work[a] += from.work[a];
    if (from.space) work = from.space->in_system(work);
    const auto of = [&](std::size_t i) { return roles_.xyz[i] < 0 ? 0.0 : work[static_cast<std::size_t>(roles_.xyz[i])]; };
    pose.tip = {of(0), of(1), of(2)};
  }
  fmt::format_to(std::back_inserter(tip_text_), "{:.6f}", static_cast<double>(instant_) * period_);
  for (const double v : {pose.tip.x, pose.tip.y, pose.tip.z, pose.direction.x, pose.direction.y, pose.direction.z})
    fmt::format_to(std::back_inserter(tip_text_), ",{:.{}f}", v, decimals_);
  tip_text_ += '\n';
}

bool SampleWriter::halted() {
  if (ended_ != SampleEnd::none) return true;
  if (options_.stop.requested()) ended_ = SampleEnd::stopped;
  else if (static_cast<double>(instant_) * period_ > options_.max_time) ended_ = SampleEnd::max_time;
  return ended_ != SampleEnd::none || !ok();
}

/// Writes one sample. Returns false if a feed hold is in force and no later override change exists, or if no more samples are requested.
bool SampleWriter::play() {
  if (!ok()) return false;
  for (; changed_ < options_.changes.size() && options_.changes[changed_].seconds <= static_cast<double>(instant_) * period_; ++changed_)
    playback_.override_to(options_.changes[changed_].share);
  if (changed_ == options_.changes.size() && playback_.is_held()) return false;
  if (halted()) return false;
  Axes at;
  if (playback_.fill(at.data(), 1) == 0) return false;
  write(at.data());
  ++instant_;
  return true;
}

void SampleWriter::take(const TimedCells& cells) {
  // Duration of the motion, s, that the playback must have received in advance. With less, the playback would brake because it lacks cells.
  constexpr double enough = 3 * Playback::reserve;
  std::size_t offered = playback_.offer(cells, 0);
  while (offered < cells.laws.size() && play()) offered += playback_.offer(cells, offered);
  while (playback_.ahead() > enough && play()) {
  }
}

void SampleWriter::resume_from(const Memory& memory) {
  playback_.resume_from(memory.playback);
  changed_ = memory.changed;
  instant_ = memory.instant;
  text_ = memory.text;
  tip_text_ = memory.tips;
  places_ = memory.places;
  ended_ = memory.ended;
}

void SampleWriter::finish() {
  playback_.finish();
  while (!playback_.done() && play()) {
  }
  flush();
}

void SampleWriter::flush() {
  errno = 0;
  const bool written = !ok() || (std::fwrite(text_.data(), 1, text_.size(), file_) == text_.size() && std::fflush(file_) == 0);
  if (!written) error_ = errno != 0 ? errno : EIO;
  text_.clear();
  if (tip_file_ == nullptr) return;
  errno = 0;
  const bool tips =
      !ok() || (std::fwrite(tip_text_.data(), 1, tip_text_.size(), tip_file_) == tip_text_.size() && std::fflush(tip_file_) == 0);
  if (!tips) error_ = errno != 0 ? errno : EIO;
  tip_text_.clear();
}

}  // namespace kadr
