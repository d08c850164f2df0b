// The Planner converts a path of straight pieces and stops into positions in time. The motion takes the least time that the axes' limits
// and the path's tolerances allow (mode `optimal` of a machine profile). Used by the other folders of motion; tested by
// tests/motion/planner_test.cpp.

#include "motion/least_time/planner.h"

#include <array>
#include <cmath>
#include <utility>

#include "action/action.h"
#include "base/arithmetic.h"
#include "motion/least_time/rest_to_rest.h"

namespace kadr {
namespace {

constexpr std::size_t planned_at = 1024;  // number of pieces after whose arrival the next plan starts

}  // namespace

Planner::Planner(const MotionLimits& limits, Sink sink)
    : axes_(limits.speed.size()), limits_(limits), sink_(std::move(sink)), now_(axes_), cutter_(limits), timer_(limits), given_(axes_) {
  cut_.path.axes = axes_;
  cut_.path.acceleration = limits.acceleration;
  cut_.path.jerk = limits.jerk;
}

void Planner::begin(const double* at) {
  settle();
  now_.at.assign(at, at + axes_);
  now_.direction.clear();
  now_.smooth.begin(at);
  cutter_.begin();
  timer_.begin();
  now_.fresh = 0;
  now_.fresh_s = 0;
}

/// Returns true if the piece to the position `to` has a different direction from the last piece.
bool Planner::turns(const double* to) const {
  constexpr double straight = 1e-9;  // the change of direction |Δu| below which two directions count as equal
  if (now_.direction.empty()) return false;
  double squares = 0, bend = 0;
  for (std::size_t a = 0; a < axes_; ++a) squares += square(to[a] - now_.at[a]);
  const double length = std::sqrt(squares);
  for (std::size_t a = 0; a < axes_; ++a) bend += square((to[a] - now_.at[a]) / length - now_.direction[a]);
  return bend > square(straight);
}

void Planner::line_to(const double* to, double feed, double tolerance, bool on_curve, std::uint64_t tag, bool paced) {
  if (halted()) return;
  if (tolerance <= 0 && turns(to)) stop();
  const std::size_t before = now_.smooth.pieces();
  now_.smooth.line_to(to, feed, tolerance, on_curve, tag, paced);
  if (now_.smooth.pieces() == before) return;
  double squares = 0;
  for (std::size_t a = 0; a < axes_; ++a) squares += square(to[a] - now_.at[a]);
  now_.direction.resize(axes_);
  for (std::size_t a = 0; a < axes_; ++a) now_.direction[a] = (to[a] - now_.at[a]) / std::sqrt(squares);
  now_.at.assign(to, to + axes_);
  ++now_.fresh;
  now_.fresh_s += std::sqrt(squares) / feed;
  if (is_due()) plan(false);
}

bool Planner::is_due() const { return now_.fresh >= planned_at || (plan_each_ > 0 && now_.fresh_s >= plan_each_); }

void Planner::stop() {
  if (!halted() && !now_.smooth.empty()) plan(true);
  const std::vector<double> at = now_.at;
  begin(at.data());
}

bool Planner::halted() {
  if (now_.ended == PlanEnd::none && stop_.requested()) now_.ended = PlanEnd::stopped;
  return now_.ended != PlanEnd::none;
}

void Planner::plan(bool last) {
  now_.fresh = 0, now_.fresh_s = 0;
  if (last && now_.smooth.is_one_line()) {
    settle();
    if (halted()) return;
    if (!cutter_.has_cut()) return straight_line();
  }
  now_.smooth.settle(last, stop_);
  settle();
  if (halted()) return;
  now_.smooth.forget(cutter_.needed_from());
  if (!in_background_ || last) {
    time_cells(now_.smooth, last);
    return fetch();
  }
  given_ = now_.smooth;
  background_.begin([this] { time_cells(given_, false); });
}

void Planner::time_cells(SmoothPath& path, bool last) {
  cut_.clear();
  cutter_.cut(path, last, stop_, cut_);
  if (!stop_.requested()) timer_.take(cut_, last, stop_);
}

void Planner::settle() {
  if (!background_.is_begun()) return;
  background_.wait();
  fetch();
}

void Planner::resume_from(const Memory& memory) {
  background_.wait();
  timer_.done().clear();
  now_ = memory.path, cutter_ = memory.cutter, timer_.resume_from(memory.window);
}

/// Emits the cells that the timer has finished.
void Planner::fetch() {
  std::vector<TimedCells> done;
  done.swap(timer_.done());
  if (halted()) return;
  for (TimedCells& cells : done) {
    sink_(cells);
    if (halted()) return;
  }
  if (timer_.is_refused()) now_.ended = PlanEnd::too_slow;
}

void Planner::straight_line() {
  SmoothPath& path = now_.smooth;
  std::array<double, max_axes> x{}, direction{}, x2{};
  path.evaluate(0, 0, x.data(), direction.data(), x2.data());
  const LineLimits limits = limits_along(limits_, direction.data(), path.feed(0));
  TimedCells made;
  made.axes = axes_;
  rest_to_rest(path.ends(), limits, made.laws);
  double s = 0;
  std::size_t piece = 0;
  for (const TimeLaw& law : made.laws) {
    for (std::size_t a = 0; a < axes_; ++a) made.path.insert(made.path.end(), {x[a] + s * direction[a], direction[a], 0, 0, 0, 0});
    piece = path.piece_at(s, piece);
    made.sources.push_back({path.tag(piece), path.feed(piece), Bend::none});
    s += law.length;
  }
  timer_.pass_cells_on(std::move(made), rest_to_rest_s(path.ends(), limits), path.tag(0));
  fetch();
}

}  // namespace kadr
