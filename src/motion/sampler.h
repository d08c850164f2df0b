#pragma once
// Sampler: positions of the axes at the servo rate, from timed cells as they come.

#include "control/action.h"
#include "motion/timed_cells.h"

namespace kadr {

class Sampler {
 public:
  /// `rate`: Hz.
  explicit Sampler(double rate) : period_(1 / rate) {}

  /// Calls back with every instant of the servo clock that falls into the cells, the first at 0: its number and the axes' positions.
  template <class Found>
  void take(const TimedCells& cells, const Found& found) {
    for (std::size_t k = 0; k < cells.laws.size(); ++k) {
      const TimeLaw& law = cells.laws[k];
      for (; due_ < law.seconds; due_ += period_) {
        cells.position(k, law.way(due_), at_.data());
        found(count_++, at_);
      }
      due_ -= law.seconds;
      if (k + 1 == cells.laws.size()) cells.position(k, law.length, at_.data());
    }
  }

  /// The end of the motion, on or behind the last instant.
  template <class Found>
  void finish(const Found& found) {
    if (count_ > 0) found(count_++, at_);
  }

 private:
  double period_;
  double due_ = 0;  // the next instant, s into the next cell
  std::uint64_t count_ = 0;
  Axes at_{};
};

}  // namespace kadr
