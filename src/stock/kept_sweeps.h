#pragma once
// KeptSweeps: stores all sweeps of a stock in order of time. A sweep that starts where the previous sweep ends needs only 12 bytes.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "stock/brick/lattice.h"

namespace kadr {

/// A stored sweep. Coordinates in mm are relative to the lattice's corner, so that single precision resolves some nanometres. For a turning
/// tool, x is measured from the axis of the part.
struct KeptSweep {
  float from[3], to[3];
  std::uint16_t tool;
  bool watched;
  bool leans;  // true if the tool is tilted: Stock::tilted_ends() returns the directions of the tool
};

class KeptSweeps {
 public:
  std::size_t size() const { return size_; }
  /// Returns the sweep with the number `i`. Several threads may call this function at once, as long as no thread adds a sweep.
  KeptSweep operator[](std::size_t i) const;
  /// Calls visit(number, sweep) for the sweeps `first` to `last` - 1.
  template <class Visit>
  void each(std::size_t first, std::size_t last, const Visit& visit) const;
  void push_back(const KeptSweep& sweep);
  /// Returns a copy of the first `count` sweeps.
  KeptSweeps first(std::size_t count) const;
  std::size_t bytes() const;

 private:
  struct Place {
    float at[3];
  };
  /// Consecutive sweeps with the same tool and flags. Each sweep starts where the previous sweep ends, so only the end points are stored.
  struct Run {
    std::uint32_t first;
    Place from;
    std::uint16_t tool;
    bool watched, leans;
  };
  struct Page {
    static constexpr std::size_t places = 1024;
    std::uint32_t run;  // number of the Run (consecutive sweeps with one tool) that contains the first sweep of this page
    std::array<Place, places> to;
  };
  const Place& to(std::size_t i) const { return pages_[i / Page::places]->to[i % Page::places]; }
  std::size_t run_of(std::size_t i) const;
  KeptSweep in_run(std::size_t i, const Run& run) const;

  std::size_t size_ = 0;
  std::vector<std::unique_ptr<Page>> pages_;
  std::deque<Run> runs_;  // runs in ascending order of `first`
};

template <class Visit>
void KeptSweeps::each(std::size_t first, std::size_t last, const Visit& visit) const {
  if (first >= last) return;
  std::size_t run = run_of(first);
  for (std::size_t i = first; i < last; ++i) {
    if (run + 1 < runs_.size() && runs_[run + 1].first == i) ++run;
    visit(i, in_run(i, runs_[run]));
  }
}

}  // namespace kadr
