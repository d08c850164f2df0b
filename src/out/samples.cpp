#include "out/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace kadr {

SampleWriter::SampleWriter(std::FILE* file, const std::vector<std::string>& axes, double rate, SpindleColumn spindle)
    : file_(file),
      axes_(std::min(axes.size(), max_axes)),
      spindle_(spindle),
      period_(1 / rate),
      decimals_(rate <= 2000 ? 9 : 12),
      sampler_(rate) {
  text_ = "t";
  for (std::size_t a = 0; a < axes_; ++a) text_ += "," + axes[a];
  text_ += spindle_ == SpindleColumn::last ? ",spindle\n" : "\n";
}

void SampleWriter::write(std::uint64_t number, const Axes& at, double spindle) {
  constexpr std::size_t chunk = 1 << 16;
  fmt::format_to(std::back_inserter(text_), "{:.6f}", static_cast<double>(number) * period_);
  for (std::size_t a = 0; a < axes_; ++a) fmt::format_to(std::back_inserter(text_), ",{:.{}f}", at[a], decimals_);
  if (spindle_ == SpindleColumn::last) fmt::format_to(std::back_inserter(text_), ",{:.{}f}", spindle, decimals_);
  text_ += '\n';
  if (text_.size() >= chunk) flush();
}

void SampleWriter::take(const TimedCells& cells) {
  sampler_.take(cells, [this](std::uint64_t number, const Axes& at, double spindle) { write(number, at, spindle); });
}

void SampleWriter::finish() {
  sampler_.finish([this](std::uint64_t number, const Axes& at, double spindle) { write(number, at, spindle); });
  flush();
  ok_ = ok_ && std::fflush(file_) == 0;
}

void SampleWriter::flush() {
  ok_ = ok_ && std::fwrite(text_.data(), 1, text_.size(), file_) == text_.size();
  text_.clear();
}

}  // namespace kadr
