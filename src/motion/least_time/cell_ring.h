#pragma once
// CellRing is a lock-free ring buffer of timed cells between the planner and the servo clock, which may run in different threads. One
// thread writes and another thread reads; neither ever waits for the other. The constructor allocates all memory.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "motion/least_time/timed_cells.h"

namespace kadr {

class CellRing {
 public:
  /// The tag of the path piece and the number of the motion that a cell belongs to: CellSource::tag and CellSource::motion.
  struct Owner {
    std::uint64_t tag = 0, motion = 0;
  };
  CellRing(std::size_t axes, std::size_t cells)
      : axes_(axes),
        size_(cells),
        laws_(cells),
        owners_(cells),
        switches_(cells),
        spindle_(cells),
        path_(cells * axes * TimedCells::terms) {}

  // The thread that writes cells into the ring (the planner) calls the functions below.

  /// Appends the cells with the index `first` and above to the ring, as many as fit. Returns the number of appended cells.
  std::size_t offer(const TimedCells& cells, std::size_t first) {
    const std::uint64_t end = end_.load(std::memory_order_relaxed), begin = begin_.load(std::memory_order_acquire);
    const std::size_t count = std::min(cells.laws.size() - first, size_ - static_cast<std::size_t>(end - begin)),
                      row = axes_ * TimedCells::terms;
    double seconds = offered_.load(std::memory_order_relaxed);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t slot = (end + k) % size_, from = first + k;
      laws_[slot] = cells.laws[from];
      owners_[slot] = {cells.sources[from].tag, cells.sources[from].motion};
      switches_[slot] = cells.sources[from].switches;
      if (!cells.spindle.empty()) spindle_[slot] = cells.spindle[from];
      std::copy_n(cells.path.begin() + static_cast<std::ptrdiff_t>(from * row), row,
                  path_.begin() + static_cast<std::ptrdiff_t>(slot * row));
      seconds += cells.laws[from].seconds;
    }
    offered_.store(seconds, std::memory_order_relaxed);
    end_.store(end + count, std::memory_order_release);
    return count;
  }
  /// Marks the end of the cells. After this call the writer must not offer further cells.
  void finish() { finished_.store(true, std::memory_order_release); }

  // The thread that reads cells from the ring (the servo clock) calls the functions below. Cells are numbered from 0 in the order in which
  // the writer offered them; the parameter `cell` is such a number.

  bool finished() const { return finished_.load(std::memory_order_acquire); }
  std::uint64_t end() const { return end_.load(std::memory_order_acquire); }
  /// The total duration, s, of all cells that were ever offered.
  double offered() const { return offered_.load(std::memory_order_relaxed); }
  /// Returns true if less than half of the ring is in use.
  bool has_room() const { return end() - begin_.load(std::memory_order_relaxed) < size_ / 2; }
  /// Frees the slots of all cells before `cell`. The reader must not read those cells again.
  void release(std::uint64_t cell) { begin_.store(cell, std::memory_order_release); }

  std::size_t axes() const { return axes_; }
  const TimeLaw& law(std::uint64_t cell) const { return laws_[cell % size_]; }
  std::uint64_t tag(std::uint64_t cell) const { return owners_[cell % size_].tag; }
  std::uint64_t motion(std::uint64_t cell) const { return owners_[cell % size_].motion; }
  Switches switches(std::uint64_t cell) const { return switches_[cell % size_]; }
  const SpindleTurn& spindle(std::uint64_t cell) const { return spindle_[cell % size_]; }
  /// Returns the `TimedCells::terms` polynomial coefficients of an axis in a cell.
  const double* path(std::uint64_t cell, std::size_t axis) const {
    return path_.data() + (cell % size_ * axes_ + axis) * TimedCells::terms;
  }

  /// The contents of the ring. Copy or restore the contents only while neither the writer nor the reader is active.
  struct Memory {
    std::uint64_t begin = 0, end = 0;
    double offered = 0;
    bool finished = false;
    std::vector<TimeLaw> laws;
    std::vector<Owner> owners;
    std::vector<Switches> switches;
    std::vector<SpindleTurn> spindle;
    std::vector<double> path;
  };
  Memory memory() const {
    Memory now{begin_.load(), end_.load(), offered_.load(), finished_.load(), {}, {}, {}, {}, {}};
    const std::size_t row = axes_ * TimedCells::terms;
    for (std::uint64_t cell = now.begin; cell < now.end; ++cell) {
      const std::size_t slot = cell % size_;
      now.laws.push_back(laws_[slot]);
      now.owners.push_back(owners_[slot]);
      now.switches.push_back(switches_[slot]);
      now.spindle.push_back(spindle_[slot]);
      now.path.insert(now.path.end(), path_.begin() + static_cast<std::ptrdiff_t>(slot * row),
                      path_.begin() + static_cast<std::ptrdiff_t>((slot + 1) * row));
    }
    return now;
  }
  void resume_from(const Memory& memory) {
    begin_ = memory.begin;
    end_ = memory.end;
    offered_ = memory.offered;
    finished_ = memory.finished;
    const std::size_t row = axes_ * TimedCells::terms;
    for (std::uint64_t cell = memory.begin; cell < memory.end; ++cell) {
      const std::size_t slot = cell % size_, from = static_cast<std::size_t>(cell - memory.begin);
      laws_[slot] = memory.laws[from];
      owners_[slot] = memory.owners[from];
      switches_[slot] = memory.switches[from];
      spindle_[slot] = memory.spindle[from];
      std::copy_n(memory.path.begin() + static_cast<std::ptrdiff_t>(from * row), row,
                  path_.begin() + static_cast<std::ptrdiff_t>(slot * row));
    }
  }

 private:
  std::size_t axes_, size_;
  std::vector<TimeLaw> laws_;
  std::vector<Owner> owners_;
  std::vector<Switches> switches_;
  std::vector<SpindleTurn> spindle_;
  std::vector<double> path_;
  std::atomic<std::uint64_t> begin_{0}, end_{0};
  std::atomic<double> offered_{0};
  std::atomic<bool> finished_{false};
};

}  // namespace kadr
