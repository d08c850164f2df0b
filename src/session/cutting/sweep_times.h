#pragma once
// SweepTimes: stores when each sweep of the stock is executed, so that the number of sweeps at an instant can be looked up. Used by
// session/cutting/cutting.
//
// Sweeps of one piece of a path take equal times; sweeps of a motion whose pieces take equal times are stored as one run.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>

namespace kadr {

/// `count` sweeps are executed completely, and `share` of the path of the next one.
struct SweepPlace {
  std::size_t count = 0;
  double share = 0;
};

class SweepTimes {
 public:
  /// States that the sweeps before `end` that have no time yet are executed one after the other, s since the start.
  ///   pre  begins is not before the end of the last sweep
  void fill(std::size_t end, double begins, double ends) {
    if (end <= size_) return;
    const double each = (ends - begins) / double(end - size_);
    if (!goes_on(begins, each)) runs_.push_back({begins, std::uint32_t(size_), float(each)});
    size_ = end;
  }
  std::size_t size() const { return size_; }
  SweepPlace at(double instant) const {
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
    double begins;        // s
    std::uint32_t first;  // sweep
    float each;           // s
  };
  static constexpr double same_time = 1e-6;  // s

  bool goes_on(double begins, double each) const {
    if (runs_.empty()) return false;
    const Run& last = runs_.back();
    const double end = last.begins + double(last.each) * double(size_ - last.first);
    return std::fabs(double(last.each) - each) <= same_time * each && std::fabs(end - begins) <= same_time;
  }

  std::size_t size_ = 0;
  std::deque<Run> runs_;  // ascending in both
};

}  // namespace kadr
