#pragma once
// ThreadChain plans consecutive threading blocks as one motion that is synchronised with the spindle: NCT 4.4.
//
//   speed of an axis, as the spindle demands it:   ┌────┐┌───   each step is spread over the same time T, half of it before
//                                                  │    └┘      the step and half after:   ──/‾‾‾\_/‾‾
//                                               ───┘           so between the steps the axes neither lead nor lag the spindle
//
// T is the shortest time for which every axis keeps its acceleration and jerk limits. The speed steps are convolved with a trapezoid of the
// duration T = W1 + W2. The trapezoid is the convolution of two rectangular pulses with the durations W1 and W2. INFERRED: the manual
// leaves thread run-in and run-out to the servo's following error.

#include <cstdint>
#include <vector>

#include "action/action.h"
#include "motion/least_time/planner.h"
#include "motion/least_time/timed_cells.h"

namespace kadr {

class ThreadChain {
 public:
  explicit ThreadChain(MotionLimits limits) : limits_(std::move(limits)) {}

  /// Clears the chain. The axes must be at rest at the position `at`.
  void begin(const Axes& at);
  /// Adds a straight thread. `seconds` is the time that follows from the spindle speed and the thread lead. If an axis is not fast enough,
  /// the thread takes longer and is not synchronised.
  void add(const Axes& to, double seconds, std::uint64_t tag);

  bool empty() const { return knots_.size() < 2; }
  /// True if the chain is full; the limit keeps memory bounded. The caller must then end the chain, so that the axes stop and synchronise
  /// again.
  bool full() const { return knots_.size() > most; }
  const Axes& start() const { return knots_.front().at; }
  const Axes& end() const { return knots_.back().at; }
  /// The time, s, from the first speed step to the last speed step.
  double seconds() const { return knots_.back().time; }
  /// Returns the time T, s, over which each speed step is spread. The motion from rest to rest takes T longer than seconds().
  double ramp() const;

  /// Returns the cells of the motion from rest to rest through all threads. The first speed step is `ramp() / 2` after the start of the
  /// motion.
  ///   law  at a time between two speed steps that is at least T/2 from both steps, position = position at the first step + thread length ·
  ///        time since the first step / thread time
  TimedCells cells() const;

  static constexpr std::size_t most = 1024;

 private:
  struct Knot {
    double time;
    Axes at;
    Axes speed;         // axis speeds in the thread that starts at this knot, mm/s or degrees/s
    std::uint64_t tag;  // tag of the thread-cutting motion that starts at this knot
  };
  struct Weight {
    // Durations of the two rectangular pulses, s, whose convolution spreads each speed step: `longer` is W1 and `shorter` is W2.
    double longer = 0, shorter = 0;
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
