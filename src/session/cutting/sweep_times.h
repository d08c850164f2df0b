#pragma once
// SweepTimes: stores when the machine executes each sweep of the stock (tool movement along a straight segment). It returns how many sweeps
// are complete at an instant. It is used by session/cutting/cutting.
//
// All sweeps of one segment take equal times. Consecutive sweeps with equal times are stored together as one run.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace kadr {

/// The progress at an instant: the number of complete sweeps, and the fraction `share` (0 to 1) of the next sweep's path.
struct SweepProgress {
  std::size_t count = 0;
  double share = 0;
};

class SweepTimes {
 public:
  /// Assigns times to the sweeps with numbers below `end` that have no time yet. These sweeps divide the time from `begins` to `ends` (s
  /// since the start) into equal parts.
  ///   pre  `begins` is not before the end of the last sweep
  void fill(std::size_t end, double begins, double ends) {
    if (end <= size_) return;
    const double each = (ends - begins) / double(end - size_);
    if (!goes_on(begins, each)) runs_.push_back({begins, std::uint32_t(size_), float(each)});
    size_ = end;
  }
  std::size_t size() const { return size_; }
  SweepProgress at(double instant) const {
    const auto later = std::partition_point(runs_.begin(), runs_.end(), [&](const Run& r) { return r.begins <= instant; });
    if (later == runs_.begin()) return {};
    const Run& run = *(later - 1);
    const std::size_t end = later == runs_.end() ? size_ : later->first;
    const double gone = instant - run.begins, each = double(run.each);
    if (!(gone < each * double(end - run.first))) return {end, 0};
    const double whole = std::floor(gone / each);
    return {std::min(run.first + std::size_t(whole), end), gone / each - whole};
  }
  std::size_t bytes() const { return runs_.size() * sizeof(Run); }

 private:
  struct Run {
    double begins;        // start time of the first sweep, s
    std::uint32_t first;  // number of the first sweep
    float each;           // duration of each sweep, s
  };
  static constexpr double same_time = 1e-6;  // s; durations that differ by less count as equal

  bool goes_on(double begins, double each) const {
    if (runs_.empty()) return false;
    const Run& last = runs_.back();
    const double end = last.begins + double(last.each) * double(size_ - last.first);
    return std::fabs(double(last.each) - each) <= same_time * each && std::fabs(end - begins) <= same_time;
  }

  std::size_t size_ = 0;
  std::deque<Run> runs_;  // the runs of sweeps with equal times, sorted by number of the first sweep and also by start time
};

}  // namespace kadr
