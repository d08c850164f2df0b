#pragma once
// The steps of a drilling cycle, and their execution (spec/sinumerik 14.2). Only src/control/sinumerik includes this file.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "control/sinumerik/sinumerik.h"

namespace kadr::sinumerik {

struct CycleStep {
  enum class Kind : std::uint8_t { rapid, feed, dwell, spindle, stop };
  Kind kind = Kind::rapid;
  Axes to{};
  AxisMask named = 0;
  double value = 0;  // feed in mm/min, 0: the feed in force; seconds
  SpindleDir dir = SpindleDir::stop;
  double angle = 0;
};

/// A cycle as its steps.
class CycleSteps final : public SteppedCycleValue<CycleSteps> {
 public:
  explicit CycleSteps(std::vector<CycleStep> steps) : steps_(std::move(steps)) {}

  Result<bool> next(Emitter& m) override {
    for (std::size_t i = 0; i < at_a_time && at_ < steps_.size(); ++i) KADR_TRY(execute(m, steps_[at_++]));
    return at_ < steps_.size();
  }

 private:
  static constexpr std::size_t at_a_time = 8;

  static Status execute(Emitter& m, const CycleStep& step) {
    Axes to = m.position.programmed;
    for (std::size_t a = 0; a < m.axis_count; ++a)
      if ((step.named >> a & 1U) != 0) to[a] = step.to[a];
    switch (step.kind) {
      case CycleStep::Kind::rapid: return m.straight(MotionKind::rapid, to, step.named);
      case CycleStep::Kind::feed: {
        const double feed = m.modal.feed;
        const FeedMode mode = m.modal.feed_mode;
        if (step.value > 0) m.modal.feed = step.value, m.modal.feed_mode = FeedMode::per_minute;
        const Status moved = m.straight(MotionKind::feed, to, step.named);
        m.modal.feed = feed;
        m.modal.feed_mode = mode;
        return moved;
      }
      case CycleStep::Kind::dwell: m.emit(Dwell{step.value}); return {};
      case CycleStep::Kind::spindle:
        m.modal.spindle = step.dir == SpindleDir::position ? SpindleDir::stop : step.dir;
        if (step.dir == SpindleDir::position) m.emit(Spindle{step.dir, 0, 1, std::nullopt, step.angle});
        else m.emit(Spindle{step.dir, step.dir == SpindleDir::stop ? 0 : m.modal.rpm});
        return {};
      case CycleStep::Kind::stop: m.emit(Stop{false}); return {};
    }
    return {};
  }

  std::vector<CycleStep> steps_;
  std::size_t at_ = 0;
};

/// Returns the pitch by the size of a metric thread, or as written; 0 if neither is given, nullopt if they contradict.
inline std::optional<double> pitch_of(double size, double pitch) {
  constexpr std::pair<double, double> sizes[] = {{3, 0.5},  {4, 0.7},  {5, 0.8},  {6, 1},    {8, 1.25}, {10, 1.5}, {12, 1.75},
                                                 {14, 2},   {16, 2},   {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3},   {27, 3},
                                                 {30, 3.5}, {33, 3.5}, {36, 4},   {39, 4},   {42, 4.5}, {45, 4.5}, {48, 5}};
  if (size == 0) return pitch;
  const auto row = std::find_if(std::begin(sizes), std::end(sizes), [&](const auto& each) { return each.first == size; });
  if (row == std::end(sizes) || (pitch != 0 && std::fabs(pitch - row->second) > 1e-9)) return std::nullopt;
  return row->second;
}

}  // namespace kadr::sinumerik
