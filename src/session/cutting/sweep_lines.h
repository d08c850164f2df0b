#pragma once
// SweepLines: stores the program line of each sweep of the stock (tool movement along a straight segment). It is used by
// session/cutting/cutting.
//
// Usually each line has one sweep and the lines are consecutive, or one line has many sweeps. Sweeps whose line number grows by a constant
// difference are stored together as one run.

#include <algorithm>
#include <cstdint>
#include <deque>

namespace kadr {

class SweepLines {
 public:
  struct Line {
    std::uint32_t line = 0;
    std::uint16_t file = 0;  // number of the file: Origin::file
    bool operator==(const Line&) const = default;
  };

  /// Assigns a program line to all sweeps with numbers below `end` that have no line yet.
  void fill(std::size_t end, Line line) {
    for (; size_ < end; ++size_) add(line);
  }
  /// Returns the line of a sweep; fill() must have assigned it.
  Line of(std::size_t sweep) const {
    const auto later = std::upper_bound(runs_.begin(), runs_.end(), sweep, [](std::size_t s, const Run& r) { return s < r.first; });
    return at(*(later - 1), sweep);
  }
  std::size_t runs() const { return runs_.size(); }

 private:
  struct Run {
    // number of the first sweep of the run; its line; difference of the line number from one sweep to the next, modulo 2³²
    std::uint32_t first, line, step;
    std::uint16_t file;
  };
  static Line at(const Run& run, std::size_t sweep) { return {run.line + run.step * std::uint32_t(sweep - run.first), run.file}; }
  void add(Line line) {
    if (!runs_.empty() && line.file == runs_.back().file) {
      Run& last = runs_.back();
      if (size_ == last.first + std::size_t{1}) last.step = line.line - last.line;
      if (at(last, size_) == line) return;
    }
    runs_.push_back({std::uint32_t(size_), line.line, 0, line.file});
  }

  std::size_t size_ = 0;
  std::deque<Run> runs_;  // sorted by number of the first sweep
};

}  // namespace kadr
