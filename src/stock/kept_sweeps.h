#pragma once
// KeptSweeps: all sweeps of a stock, in the order of time, in 12 bytes each where one begins at the end of the one before.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "stock/brick/lattice.h"

namespace kadr {

/// From the lattice's corner, so that single precision is some nanometres; x of a turning tool from the axis.
struct KeptSweep {
  float from[3], to[3];
  std::uint16_t tool;
  bool watched;
  bool leans;  // its directions stand beside: Stock::lean_ends()
};

class KeptSweeps {
 public:
  std::size_t size() const { return size_; }
  /// May be asked by several threads while none is added.
  KeptSweep operator[](std::size_t i) const;
  /// Visits (number, sweep) of all from `first` up to before `last`.
  template <class Visit>
  void each(std::size_t first, std::size_t last, const Visit& visit) const;
  void push_back(const KeptSweep& sweep);
  /// The first `count`, once more.
  KeptSweeps first(std::size_t count) const;
  std::size_t bytes() const;

 private:
  struct Place {
    float at[3];
  };
  /// Sweeps that go on where the one before ends, and are alike otherwise.
  struct Run {
    std::uint32_t first;
    Place from;
    std::uint16_t tool;
    bool watched, leans;
  };
  struct Page {
    static constexpr std::size_t places = 1024;
    std::uint32_t run;  // of its first sweep
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
