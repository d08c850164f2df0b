// LeastTime, the preparation before any speed is known. This file numbers the variables of the solver, expresses the Bézier ordinates of
// the squared path speed as linear combinations of the variables, and computes the greatest value of each variable.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.h"
#include "motion/least_time/least_time.h"

namespace kadr {
namespace {}  // namespace

/// Numbers the variables. A cell of the length h next to a stop has b = b₁ (σ/h)^(4/3), where σ is the distance from the stop and b₁ the
/// value of b at the other end of the cell. At this end b′ = 4/3 b₁/h, so the middle ordinate is a third of b₁.
void LeastTime::number_variables() {
  const std::vector<double>& h = path_->h;
  variable_.assign(n_, 0);
  scale_.assign(n_, 1);
  first_given_ = !ends_.from_stop;
  std::size_t count = 0;
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
    variable_[k] = count;
    const bool front = k == 0, back = k + 2 == n_ && ends_.to_stop;
    if (k + 1 < n_ && turns_after(k)) scale_[k + 1] = scale_[k] * h[k + 1] / h[k];
    else if (!front && !back) ++count;
    if (front && !turns_after(k)) scale_[0] = share_next_to_stop(h[0], h[1]);
    if (back && !turns_after(k)) scale_[n_ - 1] = scale_[k] * share_next_to_stop(h[n_ - 1], h[n_ - 2]);
  }
  variables_ = variable_[n_ - 1] + 1;
}

void LeastTime::prepare() {
  const TimedPath& path = *path_;
  n_ = path.cells();
  number_variables();
  m_.assign(n_, 0);
  if (first_given_) m_[0] = ends_.from.b + ends_.from.d * path.h[0] / 2;
  for (std::vector<double>* const all : {&y_, &trial_}) all->assign(variables_, 0);
  step_.assign(variables_ + beyond, 0);
  find_mixes();
  find_places();
  find_moving();
  cap_.assign(variables_, infinite);
  // In a cell b lies between the cell's middle ordinate and the middle ordinates of the two neighbours. A middle ordinate must therefore
  // obey the neighbours' limits too.
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
    double most = path.most[k];
    if (k > 0) most = std::min(most, path.most[k - 1]);
    if (k + 1 < n_) most = std::min(most, path.most[k + 1]);
    else if (!ends_.to_stop) most = std::min(most, ends_.crawl);
    cap_[variable_[k]] = std::min(cap_[variable_[k]], most / scale_[k]);
  }
  if (ends_.from_stop) keep_stop(0);
  if (ends_.to_stop) keep_stop(n_ - 1);
}

/// Expresses the ordinates at the cell boundaries by variables. At a knot (the boundary of two cells) b is interpolated linearly between
/// the middle ordinates of these cells. At a reversal b is 0, and at the end of a path that ends at crawling speed b equals the middle
/// ordinate of the last cell.
void LeastTime::find_mixes() {
  mixes_.assign(n_, {});
  for (std::size_t k = 0; k < n_; ++k) {
    const std::size_t first = first_variable(k);
    const auto add = [&](Mix& mix, std::size_t cell, double part) {
      if (cell == 0 && first_given_) mix.given += part * m_[0];
      else mix.by[variable_[cell] - first] += part * scale_[cell];
    };
    const auto knot = [&](Mix& mix, std::size_t left) {
      const double before = path_->h[left], after = path_->h[left + 1];
      add(mix, left, after / (before + after));
      add(mix, left + 1, before / (before + after));
    };
    if (k > 0 && !turns_after(k - 1)) knot(mixes_[k][0], k - 1);
    if (k == 0 && first_given_) mixes_[k][0].given = ends_.from.b;
    if (turns_after(k)) continue;
    if (k + 1 < n_) knot(mixes_[k][1], k);
    else add(mixes_[k][1], k, 1);
  }
}

void LeastTime::find_moving() {
  const TimedPath& path = *path_;
  moving_.clear();
  for (std::size_t a = 0; a < path.axes; ++a) {
    bool moves = false;
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t i = (k * path.axes + a) * places, end = i + places; i < end; ++i) moves = moves || x1_[i] != 0 || x2_[i] != 0;
    if (moves) moving_.push_back({a, 1 / (margins_.acceleration * path.acceleration[a]), 1 / (margins_.jerk * path.jerk[a])});
  }
}

void LeastTime::keep_stop(std::size_t cell) {
  double& cap = cap_[variable_[cell]];
  cap = std::min(cap, max_next_to_stop(*path_, cell, cell == 0, margins_) / scale_[cell]);
}

void LeastTime::find_places() {
  const TimedPath& path = *path_;
  for (std::vector<double>* const all : {&x1_, &x2_, &x3_}) all->resize(n_ * path.axes * places);
  for (std::size_t k = 0, i = 0; k < n_; ++k)
    for (std::size_t a = 0; a < path.axes; ++a)
      for (const double place : place_parts) {
        const Derivatives x = Derivatives::at(path.shape(k, a), place * path.h[k]);
        x1_[i] = x.x1, x2_[i] = x.x2, x3_[i] = x.x3;
        ++i;
      }
}

void LeastTime::find_envelope() { kadr::find_envelope(*path_, ends_, m_); }

}  // namespace kadr
