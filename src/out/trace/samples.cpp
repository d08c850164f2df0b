// SampleWriter: positions at the servo rate as CSV (design.md 5): t,X,Y,Z,… in s and mm (degrees), machine coordinates. For
// session/planned; tested by tests/out/samples_test.cpp.

#include "out/trace/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <utility>

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
  if (text_.size() >= chunk) flush();
}

bool SampleWriter::halted() {
  if (ended_ != SampleEnd::none) return true;
  if (options_.stop.asked()) ended_ = SampleEnd::stopped;
  else if (static_cast<double>(instant_) * period_ > options_.max_time) ended_ = SampleEnd::max_time;
  return ended_ != SampleEnd::none || !ok();
}

/// One instant. False: it stands, and nothing more will happen; or nothing more is to be written.
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
  constexpr double enough = 3 * Playback::reserve;  // ahead: it never brakes for want of cells
  std::size_t offered = playback_.offer(cells, 0);
  while (offered < cells.laws.size() && play()) offered += playback_.offer(cells, offered);
  while (playback_.ahead() > enough && play()) {
  }
}

void SampleWriter::remember(const Memory& memory) {
  playback_.remember(memory.playback);
  changed_ = memory.changed;
  instant_ = memory.instant;
  text_ = memory.text;
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
}

}  // namespace kadr
