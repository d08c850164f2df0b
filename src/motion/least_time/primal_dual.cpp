// PrimalDual, the iteration. It first makes steps over all cells, and then over the blocks of eight cells that have not converged. Used by
// motion/least_time/path_timer; tested by tests/motion/primal_dual_test.cpp.

#include "motion/least_time/primal_dual.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kadr {
namespace {

// The first and the last value of the barrier parameter μ, summed over all limits, as a fraction of the time.
constexpr double first_mu = 0.5, last_mu = 3e-3;
constexpr double smaller = 0.2;  // factor by which the barrier parameter μ is reduced between two Newton steps
constexpr int steps_of_all = 6;
constexpr std::size_t neighbours = 4;  // number of blocks on each side of an unconverged block that are solved together with this block
constexpr double slower = 0.7;         // initial guess of a cell's middle ordinate, as a fraction of its upper bound (find_envelope)

}  // namespace

/// Fills the tables of the solver, whose rows have eight cells each, with the acceleration and jerk limits of the path's cells.
///   returns  false if the solver does not support the path, because a cell with a stop is next to a reversal or there are too few cells
bool PrimalDual::prepare() {
  const TimedPath& path = *path_;
  n_ = path.cells();
  if (n_ < least_cells || (ends_->from_stop && path.turns[0] != 0) || (ends_->to_stop && path.turns[n_ - 2] != 0)) return false;
  blocks_end_ = 1 + (n_ + lanes - 1) / lanes;
  const std::size_t all = (blocks_end_ + 1) * lanes;
  find_moving();
  cells_.assign((blocks_end_ + 1) * rows * lanes, 0);
  limits_.assign((blocks_end_ + 1) * moving_.size() * per_axis * lanes, 0);
  m_.assign(all, 1);
  for (std::vector<double>* const of_cells : {&step_, &tied_}) of_cells->assign(all, 0);
  for (auto& part : products_) part.assign(all, 0);
  for (auto& part : slopes_) part.assign(all, 0);
  for (auto& part : diagonals_) part.assign(all, 0);
  restless_.assign(blocks_end_ + 1, 0);
  for (std::size_t i = 0; i < all; ++i) row(i / lanes, length)[i % lanes] = row(i / lanes, inverse)[i % lanes] = 1;
  mix();
  keep_polynomials();
  fill();
  return true;
}

void PrimalDual::find_moving() {
  const TimedPath& path = *path_;
  moving_.clear();
  for (std::size_t a = 0; a < path.axes; ++a) {
    bool moves = false;
    for (std::size_t k = 0; k < n_ && !moves; ++k) {
      const double* const c = path.shape(k, a);
      moves = c[1] != 0 || c[2] != 0 || c[3] != 0 || c[4] != 0 || c[5] != 0;
    }
    const double by_jerk = 1 / (margins.jerk * path.jerk[a]);
    if (moves) moving_.push_back({a, 1 / (by_jerk * margins.acceleration * path.acceleration[a]), by_jerk});
  }
}

/// Computes the lengths of the cells, the weights of the middle ordinates in the ordinates at the cell ends, and the greatest middle
/// ordinates.
void PrimalDual::mix() {
  const TimedPath& path = *path_;
  turns_ = false;
  for (std::size_t k = 0; k < n_; ++k) {
    const double h = path.h[k];
    const bool turn_before = k > 0 && path.turns[k - 1] != 0, turn_after = path.turns[k] != 0, is_last = k + 1 == n_;
    of_cell(k, length) = h;
    of_cell(k, inverse) = 1 / h;
    of_cell(k, limited) = ends_->stand_in(k, n_) ? 0 : 1;
    if (k > 0 && !turn_before) {
      of_cell(k, before) = h / (path.h[k - 1] + h);
      of_cell(k, own_before) = path.h[k - 1] / (path.h[k - 1] + h);
    }
    if (k == 0 && !ends_->from_stop) of_cell(k, given) = ends_->from.b;
    if (is_last && !turn_after) of_cell(k, own_after) = 1;  // At the end of the path the axes crawl at constant speed.
    if (!is_last && !turn_after) {
      of_cell(k, next_after) = h / (h + path.h[k + 1]);
      of_cell(k, own_after) = path.h[k + 1] / (h + path.h[k + 1]);
    }
    if (turn_before) tied_[k + pad] = h / path.h[k - 1], turns_ = true;
    double most = path.most[k];
    if (k > 0) most = std::min(most, path.most[k - 1]);
    if (!is_last) most = std::min(most, path.most[k + 1]);
    else if (!ends_->to_stop) most = std::min(most, ends_->crawl);
    of_cell(k, inverse_cap) = 1 / most;
  }
  first_share_ = share_next_to_stop(path.h[0], path.h[1]);
  last_share_ = share_next_to_stop(path.h[n_ - 1], path.h[n_ - 2]);
  const auto keep = [&](std::size_t stop, std::size_t next, double share) {
    const double by = share / max_next_to_stop(path, stop, stop == 0, margins);
    of_cell(next, inverse_cap) = of_cell(stop, inverse_cap) = std::max(of_cell(next, inverse_cap), by);
  };
  if (ends_->from_stop) keep(0, 1, first_share_);
  if (ends_->to_stop) keep(n_ - 1, n_ - 2, last_share_);
}

void PrimalDual::keep_polynomials() {
  for (std::size_t k = 0; k < n_; ++k)
    for (std::size_t a = 0; a < moving_.size(); ++a) {
      const double* const c = path_->shape(k, moving_[a].axis);
      float* const to = of_axis((k + pad) / lanes, a) + polynomial_row * lanes + (k + pad) % lanes;
      for (std::size_t term = 1; term < TimedPath::terms; ++term) to[(term - 1) * lanes] = static_cast<float>(c[term]);
    }
}

/// Sets the initial guess of the middle ordinates to values somewhat below their upper bounds (find_envelope). The first cells get the
/// values of the earlier solution. The last values of the earlier solution are not used: they are low because the axes had to crawl at the
/// end of that solution.
void PrimalDual::guess() {
  // Of the remaining values of the earlier solution, the last sixteenth is not used either.
  constexpr std::size_t unsure = 16;
  find_envelope(*path_, *ends_, middles_);
  for (std::size_t k = 0; k < n_; ++k) m_[k + pad] = slower * middles_[k];
  const std::vector<double>& known = ends_->guess;
  std::size_t sure = std::min(known.size(), n_);
  while (sure > 1 && known[sure - 2] >= known[sure - 1]) --sure;
  for (std::size_t k = 0; k < sure - sure / unsure; ++k) m_[k + pad] = known[k];
  if (ends_->from_stop) m_[pad] = first_share_ * m_[pad + 1];
  else m_[pad] = ends_->from.b + ends_->from.d * path_->h[0] / 2;
  for (std::size_t i = pad; i < pad + n_; ++i)
    if (tied_[i] != 0) m_[i] = tied_[i] * m_[i - 1];
  if (ends_->to_stop) m_[pad + n_ - 1] = last_share_ * m_[pad + n_ - 2];
}

double PrimalDual::seconds() const {
  double sum = 0;
  for (std::size_t k = 0; k < n_; ++k) sum += path_->h[k] / std::sqrt(m_[k + pad]);
  return sum;
}

/// Makes one Newton step for the speeds of all cells in a range of blocks.
///   returns  false if the step is not finite
bool PrimalDual::step(const Range& range, double mu, Progress& progress) {
  derive(range, mu);
  if (!newton(range)) return false;
  progress = go(range, mu);
  steps_ += static_cast<double>(range.end - range.first) / static_cast<double>(blocks_end_ - 1);
  return true;
}

PrimalDual::Range PrimalDual::widened(const Range& range, std::size_t by) const {
  Range wide{range.first > by ? range.first - by : 1, std::min(range.end + by, blocks_end_), false, false};
  const auto is_tied = [&](std::size_t cell) { return tied_[cell] != 0 || tied_[cell + 1] != 0; };
  // The solver needs the two cells next to a reversal in the same range, so the range grows where its border lies between two such cells.
  while (turns_ && wide.first > 1 && is_tied(wide.first * lanes)) --wide.first;
  while (turns_ && wide.end < blocks_end_ && is_tied(wide.end * lanes - 1)) ++wide.end;
  wide.from_stop = wide.first == 1 && ends_->from_stop;
  wide.to_stop = wide.end == blocks_end_ && ends_->to_stop;
  return wide;
}

/// Lowers the speeds in a range, so that the solver starts farther inside the limits. The speeds near the ends of the range are lowered
/// less, because the cells outside the range keep their speeds.
void PrimalDual::lower(const Range& range) {
  // `less` is the greatest reduction of a middle ordinate, as a fraction. `over` is the number of cells over which the reduction grows from
  // the ends of the range.
  constexpr double less = 0.3, over = 48;
  const std::size_t first = range.first * lanes, end = std::min(range.end * lanes, pad + n_);
  for (std::size_t i = first + 1; i + 1 < end; ++i) {
    const double from_first = range.from_stop ? over : static_cast<double>(i - first);
    const double to_end = range.to_stop ? over : static_cast<double>(end - 1 - i);
    if (tied_[i] == 0) m_[i] *= 1 - less * std::min({1.0, from_first / over, to_end / over});
    else m_[i] = tied_[i] * m_[i - 1];
  }
  if (range.from_stop) m_[pad] = first_share_ * m_[pad + 1];
  if (range.to_stop) m_[pad + n_ - 1] = last_share_ * m_[pad + n_ - 2];
}

/// Computes the speeds in a range of blocks by Newton steps until they converge. If they do not converge, the function tries a wider range
/// and a start farther inside the limits.
bool PrimalDual::settle_range(Range& range, double mu) {
  constexpr int max_steps = 16, more = 12, max_tries = 4;
  constexpr std::size_t wider = 16;  // number of blocks by which the range grows at both ends with each attempt
  for (int attempt = 0; attempt < max_tries; ++attempt) {
    double now = mu;
    if (attempt > 0) {
      range = widened(range, static_cast<std::size_t>(attempt) * wider);
      now = mu * (attempt == 1 ? 30 : 300);
      if (attempt > 1) lower(range);
      begin(range, now);
    }
    Progress progress;
    for (int k = 0; k < max_steps + attempt * more; ++k) {
      if (k > 0) now = std::max(mu, now * smaller);
      if (stop_.requested() || !step(range, now, progress)) return false;
      if (now <= mu * 1.01 && (progress.is_quiet() || (progress.stands() && progress.gap <= max_gap))) return true;
    }
  }
  return false;
}

/// Computes the speeds in all blocks that have not converged, range by range.
///   returns  false if some blocks do not converge
bool PrimalDual::settle(double mu) {
  bool all = true;
  for (std::size_t block = 1; block < blocks_end_; ++block) {
    if (restless_[block] == 0) continue;
    std::size_t last = block;
    for (std::size_t k = block; k < blocks_end_ && k <= last + 2 * neighbours; ++k)
      if (restless_[k] != 0) last = k;
    Range range = widened({block, last + 1, false, false}, neighbours);
    const bool done = settle_range(range, mu);
    all = all && done;
    if (stop_.requested()) return false;
    block = std::max(last, range.end - 1);
  }
  return all;
}

bool PrimalDual::solve(const TimedPath& path, const PathEnds& ends, StopToken stop) {
  constexpr int max_polls = 12;
  // Limits are tightened by a multiple of the excess. The multiple doubles with each check up to this value, because the excess is measured
  // between the positions at which the tightened limits apply.
  constexpr int max_tighter = 16;
  constexpr double most_of_limit = 1.01;
  path_ = &path;
  ends_ = &ends;
  stop_ = stop;
  steps_ = 0;
  if (!prepare()) return false;
  guess();
  const Range all{1, blocks_end_, ends.from_stop, ends.to_stop};
  const double limits = static_cast<double>(n_) * limits_of_cell();
  double mu = first_mu * seconds() / limits;
  if (!std::isfinite(mu)) return false;
  begin(all, mu);
  Progress progress;
  for (int k = 0; k < steps_of_all || mu > 1.01 * last_mu * seconds() / limits; ++k) {
    if (k > 0) mu = std::max(last_mu * seconds() / limits, mu * smaller);
    if (stop.requested() || !step(all, mu, progress)) return false;
  }
  bool settled = settle(mu);
  double share = greatest_share(all, 1);
  for (int look = 1; look < max_polls && settled && share > allowed && !stop.requested(); ++look) {
    settled = settle(mu);
    share = greatest_share(all, look + 1 < max_polls ? std::min(1 << look, max_tighter) : 0);
  }
  if (!settled || !(share <= most_of_limit)) return false;
  deliver_result();
  return true;
}

void PrimalDual::deliver_result() {
  middles_.assign(m_.begin() + pad, m_.begin() + static_cast<std::ptrdiff_t>(pad + n_));
  speeds_.resize(n_);
  for (std::size_t k = 0; k < n_; ++k) {
    const double m = middles_[k], h = path_->h[k];
    const double start = of_cell(k, given) + (k > 0 ? of_cell(k, before) * middles_[k - 1] : 0) + of_cell(k, own_before) * m;
    const double end = of_cell(k, own_after) * m + (k + 1 < n_ ? of_cell(k, next_after) * middles_[k + 1] : 0);
    speeds_[k] = {{start, 2 * (m - start) / h}, {end, 2 * (end - m) / h}};
    if (ends_->stand_in(k, n_)) (k == 0 ? speeds_[k].start : speeds_[k].end) = {};
  }
}

}  // namespace kadr
