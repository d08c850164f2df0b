#pragma once
// Sampler: positions of the axes at the servo rate, from timed cells as they come.

#include "control/action.h"
#include "motion/timed_cells.h"

namespace kadr {

class Sampler {
 public:
  /// `rate`: Hz.
  explicit Sampler(double rate) : period_(1 / rate) {}

  /// Calls back with every instant of the servo clock that falls into the cells, the first at 0: its number, the axes' positions, and the
  /// spindle's angle, where it is told.
  template <class Found>
  void take(const TimedCells& cells, const Found& found) {
    for (std::size_t k = 0; k < cells.laws.size(); ++k) {
      const TimeLaw& law = cells.laws[k];
      for (; due_ < law.seconds; due_ += period_) {
        const double way = law.way(due_);
        cells.position(k, way, at_.data());
        turn(cells, k, due_, way);
        found(count_++, at_, spindle_);
      }
      due_ -= law.seconds;
      if (k + 1 < cells.laws.size()) continue;
      cells.position(k, law.length, at_.data());
      turn(cells, k, law.seconds, law.length);
    }
  }

  /// The end of the motion, on or behind the last instant.
  template <class Found>
  void finish(const Found& found) {
    if (count_ > 0) found(count_++, at_, spindle_);
  }

 private:
  void turn(const TimedCells& cells, std::size_t cell, double t, double way) {
    if (!cells.spindle.empty()) spindle_ = cells.spindle[cell].at(t, way);
  }

  double period_;
  double due_ = 0;  // the next instant, s into the next cell
  std::uint64_t count_ = 0;
  Axes at_{};
  double spindle_ = 0;  // degrees
};

}  // namespace kadr
