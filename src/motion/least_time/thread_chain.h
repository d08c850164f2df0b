#pragma once
// ThreadChain: threads that follow each other, as one motion in step with the spindle. NCT 4.4.
//
//   speed of an axis, as the spindle asks:   ┌────┐┌───   each step is spread over the same time T, half before it and half after:
//                                            │    └┘      ──/‾‾‾\_/‾‾  so that between the steps the axes are where the spindle
//                                         ───┘                         says, neither ahead nor behind
//
// T is the least with which every axis keeps its acceleration and jerk: the steps are weighed with a trapezoid (W1, W2 the sides of
// the two boxes of which it is made). INFERRED: the manual leaves run-in and run-out to the servo's following error.

#include <cstdint>
#include <vector>

#include "action/action.h"
#include "motion/least_time/planner.h"
#include "motion/least_time/timed_cells.h"

namespace kadr {

class ThreadChain {
 public:
  explicit ThreadChain(MotionLimits limits) : limits_(std::move(limits)) {}

  /// Empty; the axes stand.
  void begin(const Axes& at);
  /// A straight thread in the time that the spindle gives it, s: more where an axis is not fast enough (then it is out of step).
  void add(const Axes& to, double seconds, std::uint64_t tag);

  bool empty() const { return knots_.size() < 2; }
  /// No more should be added: memory is constant. The axes come to rest and find their way into step again.
  bool full() const { return knots_.size() > most; }
  const Axes& start() const { return knots_.front().at; }
  const Axes& end() const { return knots_.back().at; }
  /// Between the first step and the last.
  double seconds() const { return knots_.back().time; }
  /// T: so much longer it takes from rest to rest.
  double ramp() const;

  /// From rest to rest, the first step `ramp() / 2` after the beginning.
  ///   law  between two steps, T/2 away from both, position = that at the step + way · time since / time of the thread
  TimedCells cells() const;

  static constexpr std::size_t most = 1024;

 private:
  struct Knot {
    double time;
    Axes at;
    Axes speed;         // after it, per s
    std::uint64_t tag;  // of what lies after it
  };
  struct Weight {
    double longer = 0, shorter = 0;  // W1, W2, s
    double time() const { return longer + shorter; }
  };
  Weight weight() const;
  Weight weight_of(const Axes& steps, double jerks) const;
  double step(std::size_t knot, std::size_t axis) const;
  std::vector<double> moments(const Weight& weight) const;
  void add_shape(double from, double to, std::size_t over, bool moves, const Weight& weight, std::vector<double>& path) const;

  MotionLimits limits_;
  std::vector<Knot> knots_;
};

}  // namespace kadr
