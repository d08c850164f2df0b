// LeastTime, the limits within the cells. This file computes the barrier function of the limits with its gradient and Hessian, and finds
// the cells in which a step would violate a limit.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.h"
#include "motion/least_time/least_time.h"

namespace kadr {
namespace {

constexpr double most_of_slack = 0.95;  // the greatest fraction of a limit's slack that one Newton step may use
// Factor in the second derivative of the path time; its exact value is 0.75. A smaller factor makes the Newton steps longer at points far
// from the limits. Near the limits the barrier dominates, so the factor has little effect.
constexpr double bend_of_time = 0.1;
constexpr std::size_t group_size = 16;  // number of neighbouring cells that are checked together for limits that a Newton step violates

constexpr auto& place_parts = LeastTime::place_parts;

using AtPlaces = std::array<double, LeastTime::places>;

template <class Function>
constexpr AtPlaces at_places_of(const Function& f) {
  AtPlaces values{};
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = f(place_parts[p]);
  return values;
}

/// Weights of a cell's three Bézier ordinates in the value of b at the sample positions: (1−t)², 2t(1−t) and t², where t is the fraction of
/// the cell.
constexpr AtPlaces weights[3] = {at_places_of([](double t) { return (1 - t) * (1 - t); }),
                                 at_places_of([](double t) { return 2 * t * (1 - t); }), at_places_of([](double t) { return t * t; })};
/// Weights of a cell's three Bézier ordinates in the derivative db/dt of the squared path speed b, where t is the fraction of the cell.
constexpr AtPlaces slopes[3] = {at_places_of([](double t) { return -2 * (1 - t); }), at_places_of([](double t) { return 2 * (1 - 2 * t); }),
                                at_places_of([](double t) { return 2 * t; })};
/// Weights of a cell's three Bézier ordinates in the second derivative d²b/dt², where t is the fraction of the cell. They are the same at
/// all sample positions.
constexpr double bends[3] = {2, -4, 2};

/// Gradient and Hessian of a function of the squared path speed b and its derivatives b′ and b″. They are stored separately for each sample
/// position.
template <class Lanes>
struct Sums {
  Lanes by[3] = {}, h00 = {}, h01 = {}, h02 = {}, h11 = {}, h12 = {}, h22 = {};

  /// Adds the matrix `bend` · r rᵀ to the Hessian with respect to b and b′, where r is the vector (e0, e1).
  KADR_LANES void add(const Lanes& bend, const Lanes& e0, const Lanes& e1) {
    const Lanes bend0 = bend * e0;
    h00 += bend0 * e0, h01 += bend0 * e1, h11 += bend * e1 * e1;
  }
  /// Adds the matrix `bend` · r rᵀ to the Hessian with respect to b, b′ and b″, where r is the vector (e0, e1, e2).
  KADR_LANES void add(const Lanes& bend, const Lanes& e0, const Lanes& e1, const Lanes& e2) {
    const Lanes bend2 = bend * e2;
    add(bend, e0, e1);
    h02 += bend2 * e0, h12 += bend2 * e1, h22 += bend2 * e2;
  }
  /// Adds the barrier −log(1 − x²) of an acceleration limit. Here x = `scale` · (e0 b + e1 b′) is the acceleration as a fraction of its
  /// limit.
  KADR_LANES void barrier(const Lanes& x, double scale, const Lanes& e0, const Lanes& e1) {
    const Lanes inverse = 1 / (1 - x * x), slope = 2 * x * inverse, by_scale = slope * scale;
    by[0] += by_scale * e0, by[1] += by_scale * e1;
    add((2 * inverse + slope * slope) * (scale * scale), e0, e1);
  }
  /// Adds the barrier −log(1 − x²) of a jerk limit. Here x = `scale` · (e0 b + e1 b′ + e2 b″) is the jerk as a fraction of its limit.
  KADR_LANES void barrier(const Lanes& x, double scale, const Lanes& e0, const Lanes& e1, const Lanes& e2) {
    const Lanes inverse = 1 / (1 - x * x), slope = 2 * x * inverse, by_scale = slope * scale;
    by[0] += by_scale * e0, by[1] += by_scale * e1, by[2] += by_scale * e2;
    add((2 * inverse + slope * slope) * (scale * scale), e0, e1, e2);
  }

  /// Computes the gradient with respect to the three ordinates of a cell of the length `h`.
  KADR_LANES void gradient(double h, std::array<double, 3>& of) const {
    const double once = 1 / h, twice = once * once;
    for (std::size_t o = 0; o < 3; ++o)
      of[o] = sum_of(by[0] * Lanes(weights[o].data()) + by[1] * (once * Lanes(slopes[o].data())) + by[2] * (twice * bends[o]));
  }
  KADR_LANES void hessian(double h, std::array<std::array<double, 3>, 3>& of) const {
    const double once = 1 / h, twice = once * once;
    for (std::size_t o = 0; o < 3; ++o) {
      const Lanes w(weights[o].data()), d = once * Lanes(slopes[o].data());
      const double q = twice * bends[o];
      const Lanes t0 = h00 * w + h01 * d + h02 * q, t1 = h01 * w + h11 * d + h12 * q, t2 = h02 * w + h12 * d + h22 * q;
      for (std::size_t p = o; p < 3; ++p)
        of[o][p] = of[p][o] = sum_of(t0 * Lanes(weights[p].data()) + t1 * (once * Lanes(slopes[p].data())) + t2 * (twice * bends[p]));
    }
  }
};

/// The values of b, b′ and b″ at the sample positions of a cell; b = ṡ² is the squared path speed (timed_path.h).
template <class Lanes>
struct CellSpeed {
  Lanes b, d;
  double q;

  KADR_LANES CellSpeed(const std::array<double, 3>& o, double h) {
    const double once = 1 / h;
    b = Lanes(weights[0].data()) * o[0] + Lanes(weights[1].data()) * o[1] + Lanes(weights[2].data()) * o[2];
    d = once * (Lanes(slopes[0].data()) * o[0] + Lanes(slopes[1].data()) * o[1] + Lanes(slopes[2].data()) * o[2]);
    q = once * once * (bends[0] * o[0] + bends[1] * o[1] + bends[2] * o[2]);
  }
};

/// The derivatives x′/2, x″ and x‴ of an axis position x at the sample positions of a cell.
template <class Lanes>
struct Shape {
  Lanes x1, x2, x3;
  KADR_LANES Shape(const std::vector<double>& x1_at, const std::vector<double>& x2_at, const std::vector<double>& x3_at, std::size_t at)
      : x1(0.5 * Lanes(&x1_at[at])), x2(&x2_at[at]), x3(&x3_at[at]) {}
  KADR_LANES Lanes acceleration(const CellSpeed<Lanes>& v) const { return x2 * v.b + x1 * v.d; }
  /// Returns the jerk of the axis divided by the path speed √b.
  KADR_LANES Lanes jerk(const CellSpeed<Lanes>& v) const { return x3 * v.b + 1.5 * x2 * v.d + x1 * v.q; }
};

}  // namespace

/// A sum of logarithms. The class multiplies many factors and calls log() once for the product.
class LeastTime::Logs {
 public:
  /// Adds log(factor) to the sum. `factor` may be as small as 1e-200.
  void take(double factor) {
    product_ *= factor;
    if (product_ < 1e-100) sum_ += std::log(product_), product_ = 1;
  }
  double sum() const { return sum_ + std::log(product_); }

 private:
  double sum_ = 0, product_ = 1;
};

LeastTime::Ordinates LeastTime::ordinates(std::size_t cell) const {
  const auto knot = [&](std::size_t left) {
    if (turns_after(left)) return 0.0;
    const double before = path_->h[left], after = path_->h[left + 1];
    return (after * m_[left] + before * m_[left + 1]) / (before + after);
  };
  const double start = cell > 0 ? knot(cell - 1) : first_given_ ? ends_.from.b : 0;
  return {start, m_[cell], cell + 1 < n_ ? knot(cell) : turns_after(cell) ? 0 : m_[cell]};
}

template <class Lanes>
KADR_LANES bool LeastTime::add_logs(Logs& logs) const {
  for (std::size_t k = 0; k < n_; ++k) {
    if (is_stop_cell(k)) continue;
    const CellSpeed<Lanes> speed(ordinates(k), path_->h[k]);
    for (const Moving& moving : moving_) {
      const Shape<Lanes> x(x1_, x2_, x3_, at_places(k, moving));
      const Lanes a = moving.by_acceleration * x.acceleration(speed), j = moving.by_jerk * x.jerk(speed);
      const Lanes slack = 1 - a * a, jerk_slack = 1 - speed.b * (j * j);
      const double product = product_of(slack * jerk_slack);
      // A product of slacks that is not a number (NaN) is rejected too, because the comparison product > 0 is then false.
      if (!(std::min(least_of(slack), least_of(jerk_slack)) > 0 && product > 0)) return false;
      logs.take(product);
    }
  }
  return true;
}

/// Evaluates the two terms of the objective for the values y of the variables: the path time T and Σ log(slack). T is infinite if y
/// violates a limit. A limit |x| ≤ 1 has the slack 1 − x². The function also sets m_ to the middle ordinates that follow from y.
LeastTime::Height LeastTime::height(const std::vector<double>& y) {
  constexpr Height none{infinite, 0};
  Logs logs;
  for (std::size_t v = 0; v < variables_; ++v) {
    if (!(y[v] > 0) || !(y[v] < cap_[v])) return none;
    logs.take(1 - y[v] / cap_[v]);
  }
  spread(y);
  const bool is_within = with_best_lanes([&](auto like) __attribute__((always_inline)) { return add_logs<decltype(like)>(logs); });
  return is_within ? Height{time(), logs.sum()} : none;
}

/// Computes the derivatives of a cell's three ordinates with respect to the variables of the previous cell, the cell itself and the next
/// cell.
void LeastTime::by_variables(std::size_t cell, std::array<Three, 3>& by) const {
  by = {mixes_[cell][0].by, {}, mixes_[cell][1].by};
  if (!(cell == 0 && first_given_)) by[1][variable_[cell] - first_variable(cell)] = scale_[cell];
}

/// Adds the contribution of the limits in one cell to the gradient and the Hessian.
template <class Lanes>
KADR_LANES void LeastTime::add_cell(std::size_t cell, double mu) {
  const CellSpeed<Lanes> speed(ordinates(cell), path_->h[cell]);
  const Lanes root = root_of(speed.b), half = where_positive(speed.b, 0.5 / root, Lanes{});
  Sums<Lanes> sums;
  for (const Moving& moving : moving_) {
    const Shape<Lanes> x(x1_, x2_, x3_, at_places(cell, moving));
    const Lanes a = x.acceleration(speed), j = x.jerk(speed);
    sums.barrier(moving.by_acceleration * a, moving.by_acceleration, x.x2, x.x1);
    sums.barrier(moving.by_jerk * root * j, moving.by_jerk, root * x.x3 + half * j, root * (1.5 * x.x2), root * x.x1);
  }
  Three gradient;
  std::array<Three, 3> hessian, by;
  sums.gradient(path_->h[cell], gradient);
  sums.hessian(path_->h[cell], hessian);
  by_variables(cell, by);
  for (std::size_t v = 0; v < 3; ++v)
    gradient_[first_variable(cell) + v] += mu * (gradient[0] * by[0][v] + gradient[1] * by[1][v] + gradient[2] * by[2][v]);
  add_hessian(cell, mu, hessian);
}

/// Adds `scale` · h to the Hessian of the solver, where h is the Hessian with respect to the three Bézier ordinates of a cell.
void LeastTime::add_hessian(std::size_t cell, double scale, const std::array<Three, 3>& h) {
  std::array<Three, 3> by, hb;
  by_variables(cell, by);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t v = 0; v < 3; ++v) hb[i][v] = scale * (h[i][0] * by[0][v] + h[i][1] * by[1][v] + h[i][2] * by[2][v]);
  const auto product = [&](std::size_t v, std::size_t w) { return by[0][v] * hb[0][w] + by[1][v] * hb[1][w] + by[2][v] * hb[2][w]; };
  const std::size_t first = first_variable(cell);
  for (std::size_t v = 0; v < 3; ++v) hessian_.h0[first + v] += product(v, v);
  hessian_.h1[first] += product(0, 1);
  hessian_.h1[first + 1] += product(1, 2);
  hessian_.h2[first] += product(0, 2);
}

/// Computes the gradient and the Hessian of the barrier function at y_. The caller must set m_ to the ordinates of y_ before the call.
void LeastTime::derivatives(double mu) {
  for (std::vector<double>* const all : {&gradient_, &hessian_.h0, &hessian_.h1, &hessian_.h2}) all->assign(variables_ + beyond, 0);
  for (std::size_t v = 0; v < variables_; ++v) {
    const double slack = 1 / (cap_[v] - y_[v]);
    gradient_[v] += mu * slack;
    hessian_.h0[v] += mu * slack * slack;
  }
  for (std::size_t k = first_given_ ? 1 : 0; k < n_; ++k) {
    const double by_m = path_->h[k] / (m_[k] * std::sqrt(m_[k]));
    gradient_[variable_[k]] -= 0.5 * by_m * scale_[k];
    hessian_.h0[variable_[k]] += bend_of_time * by_m / m_[k] * scale_[k] * scale_[k];
  }
  with_best_lanes([&](auto like) __attribute__((always_inline)) {
    for (std::size_t k = 0; k < n_; ++k)
      if (!is_stop_cell(k)) add_cell<decltype(like)>(k, mu);
  });
}

/// Returns by how much the step step_ changes the three ordinates of a cell.
LeastTime::Three LeastTime::step_in(std::size_t cell) const {
  std::array<Three, 3> by;
  by_variables(cell, by);
  const double* const step = step_.data() + first_variable(cell);
  Three o;
  for (std::size_t i = 0; i < 3; ++i) o[i] = by[i][0] * step[0] + by[i][1] * step[1] + by[i][2] * step[2];
  return o;
}

template <class Lanes>
KADR_LANES bool LeastTime::stiffen_cell(std::size_t cell, double mu) {
  const CellSpeed<Lanes> speed(ordinates(cell), path_->h[cell]), step(step_in(cell), path_->h[cell]);
  const Lanes root = root_of(speed.b), half = where_positive(speed.b, 0.5 / root, Lanes{});
  Sums<Lanes> sums;
  bool any = false;
  for (const Moving& moving : moving_) {
    const Shape<Lanes> x(x1_, x2_, x3_, at_places(cell, moving));
    const Lanes a = moving.by_acceleration * x.acceleration(speed), da = moving.by_acceleration * x.acceleration(step);
    const Lanes along = x.jerk(speed), j = moving.by_jerk * root * along;
    const Lanes dj = moving.by_jerk * (root * x.jerk(step) + half * along * step.b);
    const Lanes size_a = where_positive(da, da, -da), size_j = where_positive(dj, dj, -dj);
    const Lanes slack_a = where_positive(da, 1 - a, 1 + a), slack_j = where_positive(dj, 1 - j, 1 + j);
    const Lanes over_a = size_a - most_of_slack * slack_a, over_j = size_j - most_of_slack * slack_j;
    if (greatest_of(over_a) > 0) {
      const Lanes bend = where_positive(over_a, (3 * size_a / slack_a - 1) / (slack_a * slack_a), Lanes{});
      sums.add(bend * (moving.by_acceleration * moving.by_acceleration), x.x2, x.x1);
      any = true;
    }
    if (greatest_of(over_j) > 0) {
      const Lanes bend = where_positive(over_j, (3 * size_j / slack_j - 1) / (slack_j * slack_j), Lanes{});
      sums.add(bend * (moving.by_jerk * moving.by_jerk), root * x.x3 + half * along, root * (1.5 * x.x2), root * x.x1);
      any = true;
    }
  }
  if (!any) return false;
  std::array<Three, 3> hessian;
  sums.hessian(path_->h[cell], hessian);
  add_hessian(cell, mu, hessian);
  return true;
}

/// Shortens the step only in the cells in which it would violate limits (to first order). For this purpose the function enlarges the
/// Hessian in the directions that violate the limits.
///   returns  false if the step violates no limit
bool LeastTime::stiffen(double mu, bool first) {
  const std::size_t groups = (n_ + group_size - 1) / group_size;
  if (first) was_broken_.assign(groups, 1);
  else was_broken_.swap(broken_);
  const auto is_near = [&](std::size_t g) {
    return was_broken_[g] != 0 || (g > 0 && was_broken_[g - 1] != 0) || (g + 1 < groups && was_broken_[g + 1] != 0);
  };
  broken_.assign(groups, 0);
  bool any = false;
  for (std::size_t v = 0; v < variables_; ++v) {
    const double slack = step_[v] > 0 ? cap_[v] - y_[v] : y_[v], ratio = std::fabs(step_[v]) / slack;
    if (ratio <= most_of_slack) continue;
    hessian_.h0[v] += (3 * ratio - 1) * (step_[v] > 0 ? mu / (slack * slack) : hessian_.h0[v]);
    any = true;
  }
  with_best_lanes([&](auto like) __attribute__((always_inline)) {
    for (std::size_t g = 0; g < groups; ++g) {
      if (!is_near(g)) continue;
      for (std::size_t k = g * group_size, end = std::min(n_, k + group_size); k < end; ++k)
        if (!is_stop_cell(k) && stiffen_cell<decltype(like)>(k, mu)) broken_[g] = 1, any = true;
    }
  });
  return any;
}

}  // namespace kadr
