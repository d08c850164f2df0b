// PrimalDual, the Newton step: it solves a symmetric pentadiagonal system by the decomposition L D Lᵀ.

#include <cmath>

#include "motion/least_time/primal_dual.h"

namespace kadr {

/// Solves H · step_ = step_ for the variables `first` to `end` − 1. If rounding errors make an element d of D not clearly positive, the
/// diagonal element of H replaces d (Gill, Murray, Wright: Practical Optimization 4.4.2).
void PrimalDual::factor(std::size_t first, std::size_t end) {
  constexpr double rounding = 1e-11;
  double *const d0 = diagonals_[0].data(), *const d1 = diagonals_[1].data(), *const d2 = diagonals_[2].data(), *const x = step_.data();
  // Values of the previous matrix row: 1/d, the two elements to the right of the diagonal and the right-hand side. The names with `_before`
  // are values of the row before the previous row.
  double by_d = 0, next = 0, after = 0, value = 0, by_d_before = 0, after_before = 0, value_before = 0;
  for (std::size_t i = first; i < end; ++i) {
    const double l1 = next * by_d, l2 = after_before * by_d_before;
    double d = d0[i] - (l1 * next + l2 * after_before);
    const double to_next = (i + 1 < end ? d1[i] : 0) - l1 * after, to_after = i + 2 < end ? d2[i] : 0;
    const double z = x[i] - (l1 * value + l2 * value_before);
    if (!(d > rounding * d0[i])) d = d0[i] > 0 ? d0[i] : 1;
    by_d_before = by_d, after_before = after, value_before = value;
    by_d = 1 / d, next = to_next, after = to_after, value = z;
    d0[i] = by_d, d1[i] = to_next, d2[i] = to_after, x[i] = z;
  }
  double x1 = 0, x2 = 0;
  for (std::size_t i = end; i-- > first;) {
    const double found = (x[i] - d1[i] * x1 - d2[i] * x2) * d0[i];
    x2 = x1, x1 = x[i] = found;
  }
}

/// Merges the variables of reversals. A cell after a reversal has no variable of its own. The matrix row of this cell is added to the row
/// of the previous cell, and all later rows move up by one.
///   returns  the index after the last variable
std::size_t PrimalDual::merge_turns(std::size_t first, std::size_t end) {
  auto& [d0, d1, d2] = diagonals_;
  std::size_t variable = first;
  for (std::size_t i = first + 1; i < end; ++i) {
    if (const double share = tied_[i]; share != 0) {
      d0[variable] += share * share * d0[i];
      step_[variable] += share * step_[i];
      d1[variable] = share * d1[i];
      d2[variable] = share * d2[i];
      continue;
    }
    ++variable;
    d0[variable] = d0[i], d1[variable] = d1[i], d2[variable] = d2[i], step_[variable] = step_[i];
  }
  return variable + 1;
}

void PrimalDual::spread_turns(std::size_t first, std::size_t end, std::size_t variables) {
  std::size_t variable = variables;
  for (std::size_t i = end; i-- > first;) step_[i] = tied_[i] != 0 && i > first ? tied_[i] * step_[variable - 1] : step_[--variable];
}

bool PrimalDual::newton(const Range& range) {
  auto& [d0, d1, d2] = diagonals_;
  const std::size_t all = range.first * lanes, cells_end = std::min(range.end * lanes, pad + n_);
  // The first cell has no variable: its middle ordinate is fixed, or it depends on the second cell.
  std::size_t first = all + 1, end = cells_end;
  if (range.from_stop) {
    const double share = first_share_;
    d0[first] += share * share * d0[all] + 2 * share * d1[all];
    d1[first] += share * d2[all];
    step_[first] += share * step_[all];
  }
  const bool is_inside = range.end < blocks_end_;
  if (is_inside) --end;
  if (range.to_stop) {
    const double share = last_share_;
    --end;
    d0[end - 1] += share * share * d0[end] + 2 * share * d1[end - 1];
    d1[end - 2] += share * d2[end - 2];
    step_[end - 1] += share * step_[end];
  }
  const std::size_t variables_end = turns_ ? merge_turns(first, end) : end;
  factor(first, variables_end);
  if (turns_) spread_turns(first, end, variables_end);
  step_[all] = range.from_stop ? first_share_ * step_[first] : 0;
  if (range.to_stop) step_[end] = last_share_ * step_[end - 1];
  else if (is_inside) step_[end] = 0;
  step_[all - 1] = 0;
  for (std::size_t i = cells_end; i <= range.end * lanes; ++i) step_[i] = 0;
  return std::isfinite(step_[first]);
}

}  // namespace kadr
