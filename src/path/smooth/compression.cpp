// Compression joins short straight feed motions into one motion (nct 4.7, N3103 Accuracy). Used by machine/virtual_machine; tested by
// tests/path/compression_test.cpp.

#include "path/smooth/compression.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "action/by_kind.h"

namespace kadr {
namespace {

/// Returns the motion of an action if the motion may be joined with other motions; otherwise nullptr.
const Motion* joinable(const Action& action) {
  const auto* const motion = motion_of(action);
  return motion != nullptr && motion->join > 0 && motion->kind == MotionKind::feed && !motion->detail ? motion : nullptr;
}

bool is_single_block_stop(const Action& action) {
  const auto* const stop = std::get_if<Stop>(&action.what);
  return stop != nullptr && stop->reason == StopReason::single_block;
}

/// Returns the travel, mm or degrees, of the axis with the longest travel.
double longest_travel(const Axes& from, const Axes& to) {
  double travel = 0;
  for (std::size_t i = 0; i < max_axes; ++i) travel = std::max(travel, std::fabs(to[i] - from[i]));
  return travel;
}

}  // namespace

std::size_t Compression::take(ActionBatch& batch, const Axes& from, bool last) {
  of_before_ = 0;
  held_before_ = held_.has_value();
  if (!held_ && std::none_of(batch.begin(), batch.end(), [](const Action& action) { return joinable(action) != nullptr; })) return 0;
  from_ = from;
  out_.clear();
  for (Action& action : batch) {
    if (joinable(action) != nullptr) {
      join(action);
    } else if (held_ && is_single_block_stop(action)) {
      stop_ = std::move(action);
    } else {
      let_out();
      if (const auto* const motion = motion_of(action)) from_ = motion->to;
      else if (const auto* const frame = std::get_if<FrameChange>(&action.what)) from_ = frame->work;
      out_.add() = std::move(action);
    }
  }
  if (last) let_out();
  std::swap(batch, out_);
  return of_before_;
}

/// Extends the stored motion to the end of this motion. The joined motion is emitted if its travel is long enough or the axes must stop at
/// its end.
void Compression::join(Action& action) {
  auto& motion = std::get<Motion>(action.what);
  if (held_) motion.named |= std::get<Motion>(held_->what).named;
  drop();
  held_before_ = false;
  if (longest_travel(from_, motion.to) > motion.join || motion.exact || motion.in_position) {
    from_ = motion.to;
    out_.add() = std::move(action);
  } else {
    held_ = std::move(action);
  }
}

void Compression::let_out() {
  if (!held_) return;
  const std::size_t size = out_.size();
  const Axes& to = std::get<Motion>(held_->what).to;
  if (longest_travel(from_, to) > 0) {
    from_ = to;
    out_.add() = std::move(*held_);
  }
  if (stop_) out_.add() = std::move(*stop_);
  if (held_before_) of_before_ += out_.size() - size;
  drop();
}

}  // namespace kadr
