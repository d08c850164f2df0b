// Finds the line of a job that a Grbl controller executes now. Used by grbl_link, tested by tests/drive/grbl_link_test.cpp.

#include "drive/grbl/line_tracker.h"

#include <algorithm>
#include <cmath>

namespace kadr::drive {
namespace {

// A position counts as farther along the path only if it is nearer by this distance, mm: half of the last digit of a report and of a step.
constexpr double clearly_nearer = 0.004;
// Distance, mm, by which a position may be before the last one on the same segment: the digits of the report are rounded.
constexpr double step_back = 0.01;
// The stepper has taken up to this many short blocks out of the planner that are not executed yet (SEGMENT_BUFFER_SIZE of stepper.h), and
// one that it executes.
constexpr std::size_t blocks_in_stepper = 7;

struct Nearest {
  double distance, along;
};

Nearest nearest_on(const GrblPoint& a, const GrblPoint& b, const GrblPoint& p, double from) {
  double length_sq = 0, dot = 0;
  for (std::size_t i = 0; i < grbl_axes; ++i) {
    length_sq += (b[i] - a[i]) * (b[i] - a[i]);
    dot += (p[i] - a[i]) * (b[i] - a[i]);
  }
  const double length = std::sqrt(length_sq);
  const double along = length > 0 ? std::clamp(dot / length, std::min(from, length), length) : 0;
  double off_sq = 0;
  for (std::size_t i = 0; i < grbl_axes; ++i) {
    const double at = length > 0 ? a[i] + (b[i] - a[i]) * along / length : a[i];
    off_sq += (p[i] - at) * (p[i] - at);
  }
  return {std::sqrt(off_sq), along};
}

}  // namespace

void LineTracker::sent(const JobLine& line) {
  lines_.push_back({line.number, line.seconds, line.path, line.probes});
  seconds_ += line.seconds;
}

void LineTracker::accepted() {
  accepted_ = std::min(accepted_ + 1, lines_.size());
  // A line that moves nothing is executed when it is accepted, if everything before it is executed.
  while (accepted_ > 0 && lines_.front().path.empty()) drop(1);
}

void LineTracker::drop(std::size_t entries) {
  for (; entries > 0; --entries) {
    seconds_ -= lines_.front().seconds;
    if (!lines_.front().path.empty()) {
      last_line_ = lines_.front().number;
      end_ = lines_.front().path.back();
      if (lines_.front().probes) end_.reset();  // it ends where the probe touches
    }
    lines_.pop_front();
    accepted_ -= std::min<std::size_t>(accepted_, 1);
    ++executed_;
    now_ = {};
  }
  if (lines_.empty()) seconds_ = 0;  // without the rounding errors of the sum
}

void LineTracker::all_executed() { drop(accepted_); }

double LineTracker::off_end(const GrblPoint& machine) const { return end_ ? nearest_on(*end_, *end_, machine, 0).distance : 0; }

void LineTracker::clear() {
  lines_.clear();
  executed_ = 0;
  last_line_.reset();
  end_.reset();
  accepted_ = 0;
  seconds_ = 0;
  now_ = {};
}

/// Returns the first line that can be in execution. Each accepted line that moves has at least one block in the planner until the stepper
/// has taken it.
std::size_t LineTracker::least_entry(std::optional<int> blocks_in_use) const {
  if (!blocks_in_use) return 0;
  std::size_t may_wait = static_cast<std::size_t>(std::max(*blocks_in_use, 0)) + blocks_in_stepper;
  std::size_t least = accepted_;
  while (least > 0 && may_wait > 0) {
    --least;
    if (!lines_[least].path.empty()) --may_wait;
  }
  return least;
}

Tracked LineTracker::at(const GrblPoint& machine, std::optional<int> blocks_in_use) {
  Tracked result{last_line_, 0, true};
  const std::size_t least = least_entry(blocks_in_use);
  std::optional<Place> found;
  double best = INFINITY;
  for (std::size_t e = least; e < lines_.size(); ++e) {
    const auto& path = lines_[e].path;
    const bool is_now = e == 0;
    for (std::size_t s = is_now ? now_.segment : 0; s + 1 < path.size(); ++s) {
      const double from = is_now && s == now_.segment ? std::max(0.0, now_.along - step_back) : 0;
      const auto [distance, along] = nearest_on(path[s], path[s + 1], machine, from);
      const bool has_place = best <= tolerance_;
      if (has_place && distance >= best - clearly_nearer) {
        e = lines_.size();  // the earliest place is found
        break;
      }
      if (distance >= best) continue;
      best = distance;
      found = Place{e, s, along};
    }
  }
  if (!found) return result;  // no line moves: nothing to compare with
  result.off = best;
  result.on_path = best <= tolerance_;
  if (!result.on_path) return result;
  // A line that has not begun may lie where the tool is: at its first point nothing of it is executed yet, and the tool is at the end of
  // the line before it.
  const bool has_begun = found->entry == 0 || found->along > tolerance_ || found->segment > 0;
  if (!has_begun) {
    std::size_t before = found->entry - 1;
    while (before > 0 && lines_[before].path.empty()) --before;
    const auto& path = lines_[before].path;
    if (path.size() < 2 || nearest_on(path.back(), path.back(), machine, 0).distance > 2 * tolerance_) return result;
    found = Place{before, path.size() - 2, 0};
  }
  drop(found->entry);
  now_ = {0, found->segment, found->along};
  result.line = last_line_ = lines_.front().number;
  return result;
}

}  // namespace kadr::drive
