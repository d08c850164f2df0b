#pragma once
// KeptSweeps: all sweeps of a stock in order of time. A sweep that begins where the sweep before it ends takes 12 bytes.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "stock/brick/lattice.h"

namespace kadr {

/// Coordinates from the lattice's corner, so that single precision resolves some nanometres. For a turning tool x is measured from
/// the axis.
struct KeptSweep {
  float from[3], to[3];
  std::uint16_t tool;
  bool watched;
  bool leans;  // tilted tool: its directions are in Stock::lean_ends()
};

class KeptSweeps {
 public:
  std::size_t size() const { return size_; }
  /// Several threads may call it as long as none adds a sweep.
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
  /// Consecutive sweeps, each of which begins where the one before it ends, with the same tool and flags.
  struct Run {
    std::uint32_t first;
    Place from;
    std::uint16_t tool;
    bool watched, leans;
  };
  struct Page {
    static constexpr std::size_t places = 1024;
    std::uint32_t run;  // the run of the page's first sweep
    std::array<Place, places> to;
  };
  const Place& to(std::size_t i) const { return pages_[i / Page::places]->to[i % Page::places]; }
  std::size_t run_of(std::size_t i) const;
  KeptSweep in_run(std::size_t i, const Run& run) const;

  std::size_t size_ = 0;
  std::vector<std::unique_ptr<Page>> pages_;
  std::deque<Run> runs_;  // ascending
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
