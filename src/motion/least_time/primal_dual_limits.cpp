// PrimalDual, the limits within the cells, with eight cells in parallel. This file computes the contributions of the limits to the matrix,
// the change of slacks and dual variables in a step, and the cells in which a limit is exceeded. Used by motion/least_time/primal_dual.

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/least_time/primal_dual.h"

namespace kadr {
namespace {

constexpr std::array<double, 3> place_of = {0, 0.5, 1};
// Lower bound of the squared path speed b, as a fraction of the cell's middle ordinate. The bound is needed because b is 0 at a reversal.
constexpr double least_b = 1e-6;
constexpr double least_slack = 1e-5;   // lower bound of a slack, as a fraction of the limit
constexpr double greatest_dual = 1e3;  // upper bound of a dual variable, s; the slack that belongs to it is a fraction of the limit
constexpr double least_dual = 0.05;    // lower bound of a dual variable, as a fraction of the barrier parameter μ
constexpr double kept = 0.2;           // least fraction of a slack or a dual variable that remains after a Newton step
constexpr double first_slack = 0.2;    // lower bound of a slack in the initial guess, as a fraction of the limit
// Factor in the second derivative of the time of a cell. The time is proportional to m^(−1/2), where m is the middle ordinate of the cell's
// squared speed.
constexpr double second_derivative_of_time = 0.75;

}  // namespace

/// The squared path speed b and its derivatives b′ and b″/2 in eight cells, computed from the Bézier ordinates of the cells.
template <class Lanes>
struct PrimalDual::BlockSpeed {
  Lanes o0, o1, o2, by_length;

  KADR_LANES BlockSpeed(const double* rows, const double* m, bool is_step) : o1(m), by_length(rows + inverse * lanes) {
    o0 = Lanes(rows + before * lanes) * Lanes(m - 1) + Lanes(rows + own_before * lanes) * o1;
    if (!is_step) o0 += Lanes(rows + given * lanes);
    o2 = Lanes(rows + own_after * lanes) * o1 + Lanes(rows + next_after * lanes) * Lanes(m + 1);
  }
  KADR_LANES Lanes half_bend() const { return (o0 - 2 * o1 + o2) * by_length * by_length; }
  KADR_LANES Lanes at(double t) const { return ((1 - t) * (1 - t)) * o0 + (2 * t * (1 - t)) * o1 + (t * t) * o2; }
  KADR_LANES Lanes slope(double t) const { return 2 * ((1 - t) * (o1 - o0) + t * (o2 - o1)) * by_length; }
  /// Returns b with a positive lower bound, so that the caller can take its square root and divide by it.
  KADR_LANES Lanes safe_at(double t, const Lanes& is_limited) const {
    return where_positive(is_limited, greater(at(t), least_b * o1), Lanes::all(1));
  }
};

/// The slacks and dual variables of an upper and a lower limit in eight cells: ±c ≤ 1, where c is an acceleration or jerk as a fraction of
/// its limit.
template <class Lanes>
struct PrimalDual::Pairs {
  float* rows;
  // `by_up` and `by_down` are the reciprocals of the slacks of the upper limit and of the lower limit.
  Lanes slack_up, slack_down, dual_up, dual_down, by_up, by_down;

  KADR_LANES explicit Pairs(float* from)
      : rows(from), slack_up(from), slack_down(from + lanes), dual_up(from + 2 * lanes), dual_down(from + 3 * lanes) {
    const Lanes both = 1 / (slack_up * slack_down);
    by_up = slack_down * both, by_down = slack_up * both;
  }

  KADR_LANES static Lanes moved_slack(const Lanes& slack, const Lanes& by) {
    return greater(greater(slack + by, kept * slack), Lanes::all(least_slack));
  }
  KADR_LANES static Lanes moved_dual(const Lanes& dual, const Lanes& to, double mu) {
    return lesser(greater(greater(to, kept * dual), Lanes::all(least_dual * mu)), Lanes::all(greatest_dual));
  }
  /// Updates slacks and dual variables for a step that changes the acceleration or jerk c by `dc`, both as fractions of the limit.
  /// `tangent` is the additional reduction of both slacks that follows from the tangent to the jerk limit.
  ///   returns  the sum of slack · dual of the upper and the lower limit after the step
  KADR_LANES Lanes move(const Lanes& c, const Lanes& dc, const Lanes& tangent, double mu) {
    const Lanes up = (1 - c - slack_up) - dc - tangent, down = (1 + c - slack_down) + dc - tangent;
    const Lanes new_up = moved_slack(slack_up, up), new_down = moved_slack(slack_down, down);
    const Lanes new_dual_up = moved_dual(dual_up, (mu - dual_up * up) * by_up, mu);
    const Lanes new_dual_down = moved_dual(dual_down, (mu - dual_down * down) * by_down, mu);
    new_up.to(rows), new_down.to(rows + lanes), new_dual_up.to(rows + 2 * lanes), new_dual_down.to(rows + 3 * lanes);
    return new_up * new_dual_up + new_down * new_dual_down;
  }
  KADR_LANES static void begin(float* rows, const Lanes& c, double mu) {
    const Lanes up = greater(1 - c, Lanes::all(first_slack)), down = greater(1 + c, Lanes::all(first_slack));
    up.to(rows);
    down.to(rows + lanes);
    (mu / up).to(rows + 2 * lanes);
    (mu / down).to(rows + 3 * lanes);
  }
};

/// Gradient and Hessian with respect to b, b′ and b″/2 at one sample position of a cell.
template <class Lanes>
struct PrimalDual::PlaceSums {
  Lanes g0 = {}, g1 = {}, g2 = {}, h00 = {}, h01 = {}, h02 = {}, h11 = {}, h12 = {}, h22 = {};

  /// Adds the contribution of a jerk limit to the gradient and the Hessian. The jerk as a fraction of its limit is c = e0 b + e1 b′ + e2
  /// b″/2. `tangent` is the derivative with respect to b of the slack reduction that the tangent to the jerk limit causes.
  KADR_LANES void add_jerk(const Pairs<Lanes>& of, double mu, const Lanes& c, const Lanes& e0, const Lanes& e1, const Lanes& e2,
                           const Lanes& tangent) {
    const Lanes bend_up = of.dual_up * of.by_up, bend_down = of.dual_down * of.by_down, both = bend_up + bend_down;
    const Lanes up = mu * of.by_up - bend_up * (1 - c - of.slack_up), down = mu * of.by_down - bend_down * (1 + c - of.slack_down);
    const Lanes along = up - down;
    g0 += along * e0 + (up + down) * tangent, g1 += along * e1, g2 += along * e2;
    const Lanes b0 = both * e0, b1 = both * e1, skew = (bend_up - bend_down) * tangent;
    h00 += (b0 + 2 * skew) * e0 + both * tangent * tangent;
    h01 += (b0 + skew) * e1, h02 += (b0 + skew) * e2;
    h11 += b1 * e1, h12 += b1 * e2, h22 += both * e2 * e2;
  }
  /// Adds the contribution of an acceleration limit to the gradient and the Hessian. The acceleration as a fraction of its limit is c = e0
  /// b + e1 b′.
  KADR_LANES void add_acceleration(const Pairs<Lanes>& of, double mu, const Lanes& c, const Lanes& e0, const Lanes& e1) {
    const Lanes bend_up = of.dual_up * of.by_up, bend_down = of.dual_down * of.by_down, both = bend_up + bend_down;
    const Lanes along = mu * (of.by_up - of.by_down) - bend_up * (1 - c - of.slack_up) + bend_down * (1 + c - of.slack_down);
    g0 += along * e0, g1 += along * e1;
    const Lanes b0 = both * e0;
    h00 += b0 * e0, h01 += b0 * e1, h11 += both * e1 * e1;
  }
};

/// Gradient and Hessian with respect to the three Bézier ordinates of each of eight cells.
template <class Lanes>
struct PrimalDual::OrdinateSums {
  Lanes g0 = {}, g1 = {}, g2 = {}, h00 = {}, h01 = {}, h02 = {}, h11 = {}, h12 = {}, h22 = {};

  KADR_LANES void add(const PlaceSums<Lanes>& of, double t, const Lanes& by_length) {
    const double w0 = (1 - t) * (1 - t), w1 = 2 * t * (1 - t), w2 = t * t;
    const Lanes s0 = (-2 * (1 - t)) * by_length, s1 = (2 * (1 - 2 * t)) * by_length, s2 = (2 * t) * by_length;
    const Lanes d0 = by_length * by_length, d1 = -2 * d0;
    const Lanes r0 = of.h00 * w0 + of.h01 * s0 + of.h02 * d0, r1 = of.h00 * w1 + of.h01 * s1 + of.h02 * d1,
                r2 = of.h00 * w2 + of.h01 * s2 + of.h02 * d0;
    const Lanes t0 = of.h01 * w0 + of.h11 * s0 + of.h12 * d0, t1 = of.h01 * w1 + of.h11 * s1 + of.h12 * d1,
                t2 = of.h01 * w2 + of.h11 * s2 + of.h12 * d0;
    const Lanes u0 = of.h02 * w0 + of.h12 * s0 + of.h22 * d0, u1 = of.h02 * w1 + of.h12 * s1 + of.h22 * d1,
                u2 = of.h02 * w2 + of.h12 * s2 + of.h22 * d0;
    h00 += w0 * r0 + s0 * t0 + d0 * u0, h01 += w0 * r1 + s0 * t1 + d0 * u1, h02 += w0 * r2 + s0 * t2 + d0 * u2;
    h11 += w1 * r1 + s1 * t1 + d1 * u1, h12 += w1 * r2 + s1 * t2 + d1 * u2, h22 += w2 * r2 + s2 * t2 + d0 * u2;
    g0 += w0 * of.g0 + s0 * of.g1 + d0 * of.g2;
    g1 += w1 * of.g0 + s1 * of.g1 + d1 * of.g2;
    g2 += w2 * of.g0 + s2 * of.g1 + d0 * of.g2;
  }
  KADR_LANES void take(const Lanes& share) {
    for (Lanes* const sum : {&g0, &g1, &g2, &h00, &h01, &h02, &h11, &h12, &h22}) *sum *= share;
  }
};

/// Computes the derivatives x′, x″ and x‴ of each axis position, divided by the jerk limit, at the positions where limits are checked.
template <class Lanes>
KADR_LANES void PrimalDual::fill_shapes() {
  for (std::size_t block = 1; block < blocks_end_; ++block) {
    const Lanes h(row(block, length));
    for (std::size_t a = 0; a < moving_.size(); ++a) {
      float* const of = of_axis(block, a);
      const float* const c = of + polynomial_row * lanes;
      const Lanes c1(c), c2(c + lanes), c3(c + 2 * lanes), c4(c + 3 * lanes), c5(c + 4 * lanes);
      for (std::size_t p = 0; p < places; ++p) {
        const Lanes s = place_of[p] * h;
        float* const to = of + shape_row(p) * lanes;
        (moving_[a].by_jerk * (c1 + s * (2 * c2 + s * (3 * c3 + s * (4 * c4 + s * (5 * c5)))))).to(to);
        (moving_[a].by_jerk * (2 * c2 + s * (6 * c3 + s * (12 * c4 + s * (20 * c5))))).to(to + lanes);
        (moving_[a].by_jerk * (6 * c3 + s * (24 * c4 + s * (60 * c5)))).to(to + 2 * lanes);
      }
    }
  }
}

template <class Lanes>
KADR_LANES void PrimalDual::begin_duals(const Range& range, double mu) {
  for (std::size_t block = range.first; block < range.end; ++block) {
    double* const of_block = row(block, length);
    const BlockSpeed<Lanes> speed(of_block, &m_[block * lanes], false);
    const Lanes is_limited(of_block + limited * lanes), bend = speed.half_bend();
    for (std::size_t p = 0; p < places; ++p) {
      const Lanes b = speed.safe_at(place_of[p], is_limited), d = speed.slope(place_of[p]), root = root_of(b);
      for (std::size_t a = 0; a < moving_.size(); ++a) {
        float* const of = of_axis(block, a);
        const Lanes x1(of + shape_row(p) * lanes), x2(of + shape_row(p) * lanes + lanes), x3(of + shape_row(p) * lanes + 2 * lanes);
        Pairs<Lanes>::begin(of + jerk_row(p) * lanes, is_limited * root * (x1 * bend + 1.5 * x2 * d + x3 * b), mu);
        if (p > 0) Pairs<Lanes>::begin(of + acceleration_row(p) * lanes, is_limited * moving_[a].ratio * (0.5 * x1 * d + x2 * b), mu);
      }
    }
    const Lanes slack = greater(1 - speed.o1 * Lanes(of_block + inverse_cap * lanes), Lanes::all(first_slack));
    slack.to(of_block + cap_slack * lanes);
    (mu / slack).to(of_block + cap_dual * lanes);
  }
}

/// Computes the contribution of each cell to the matrix and the gradient.
template <class Lanes>
KADR_LANES void PrimalDual::build(const Range& range, double mu) {
  for (std::size_t block = range.first; block < range.end; ++block) {
    const double* const of_block = row(block, length);
    const std::size_t i = block * lanes;
    const BlockSpeed<Lanes> speed(of_block, &m_[i], false);
    const Lanes is_limited(of_block + limited * lanes), bend = speed.half_bend();
    OrdinateSums<Lanes> sums;
    for (std::size_t p = 0; p < places; ++p) {
      const Lanes b = speed.safe_at(place_of[p], is_limited), d = speed.slope(place_of[p]), root = root_of(b), tangent = 0.5 / b;
      PlaceSums<Lanes> at_place;
      for (std::size_t a = 0; a < moving_.size(); ++a) {
        float* const of = of_axis(block, a);
        const Lanes x1(of + shape_row(p) * lanes), x2(of + shape_row(p) * lanes + lanes), x3(of + shape_row(p) * lanes + 2 * lanes);
        const Lanes e0 = root * x3, e1 = root * (1.5 * x2), e2 = root * x1;
        at_place.add_jerk(Pairs<Lanes>(of + jerk_row(p) * lanes), mu, e0 * b + e1 * d + e2 * bend, e0, e1, e2, tangent);
        if (p == 0) continue;
        const Lanes f0 = moving_[a].ratio * x2, f1 = (0.5 * moving_[a].ratio) * x1;
        at_place.add_acceleration(Pairs<Lanes>(of + acceleration_row(p) * lanes), mu, f0 * b + f1 * d, f0, f1);
      }
      sums.add(at_place, place_of[p], speed.by_length);
    }
    sums.take(is_limited);
    // `fall` is the decrease of the cell's time T per increase of its middle ordinate m: −dT/dm.
    const Lanes m = speed.o1, by_m = 1 / m, fall = (0.5 * Lanes(of_block + length * lanes)) * by_m * by_m * root_of(m);
    const Lanes by_cap(of_block + inverse_cap * lanes), slack(of_block + cap_slack * lanes), dual(of_block + cap_dual * lanes),
        by_slack = 1 / slack;
    sums.h11 += (2 * second_derivative_of_time) * fall * by_m + dual * by_slack * by_cap * by_cap;
    sums.g1 += (mu - dual * (1 - m * by_cap - slack)) * by_slack * by_cap - fall;
    const Lanes p(of_block + before * lanes), q(of_block + own_before * lanes), u(of_block + own_after * lanes),
        v(of_block + next_after * lanes);
    (p * p * sums.h00).to(&products_[0][i]);
    (p * (q * sums.h00 + sums.h01 + u * sums.h02)).to(&products_[1][i]);
    (p * v * sums.h02).to(&products_[2][i]);
    (q * q * sums.h00 + sums.h11 + u * u * sums.h22 + 2 * (q * (sums.h01 + u * sums.h02) + u * sums.h12)).to(&products_[3][i]);
    (v * (q * sums.h02 + sums.h12 + u * sums.h22)).to(&products_[4][i]);
    (v * v * sums.h22).to(&products_[5][i]);
    (p * sums.g0).to(&slopes_[0][i]);
    (q * sums.g0 + sums.g1 + u * sums.g2).to(&slopes_[1][i]);
    (v * sums.g2).to(&slopes_[2][i]);
  }
}

/// Adds the contributions of all cells of a range. The sums are the pentadiagonal matrix and the right-hand side.
template <class Lanes>
KADR_LANES void PrimalDual::gather(const Range& range) {
  for (std::size_t block = range.first; block < range.end; ++block) {
    const std::size_t i = block * lanes;
    (Lanes(&products_[3][i]) + Lanes(&products_[5][i - 1]) + Lanes(&products_[0][i + 1])).to(&diagonals_[0][i]);
    (Lanes(&products_[4][i]) + Lanes(&products_[1][i + 1])).to(&diagonals_[1][i]);
    Lanes(&products_[2][i + 1]).to(&diagonals_[2][i]);
    (-(Lanes(&slopes_[1][i]) + Lanes(&slopes_[2][i - 1]) + Lanes(&slopes_[0][i + 1]))).to(&step_[i]);
  }
}

/// Applies the step to the slacks and the dual variables. move() applies the step to the middle ordinates.
template <class Lanes>
KADR_LANES PrimalDual::Progress PrimalDual::update(const Range& range, double mu) {
  Lanes all_worst = Lanes::all(1), all_steps = {}, all_gaps = {};
  for (std::size_t block = range.first; block < range.end; ++block) {
    double* const of_block = row(block, length);
    const std::size_t i = block * lanes;
    const BlockSpeed<Lanes> speed(of_block, &m_[i], false), by(of_block, &step_[i], true);
    const Lanes is_limited(of_block + limited * lanes), bend = speed.half_bend(), by_bend = by.half_bend();
    Lanes worst = Lanes::all(1), gap = {};
    const auto look_at = [&](const Lanes& c) __attribute__((always_inline)) {
      worst = lesser(worst, where_positive(is_limited, lesser(1 - c, 1 + c), Lanes::all(1)));
    };
    for (std::size_t p = 0; p < places; ++p) {
      const Lanes b = speed.safe_at(place_of[p], is_limited), d = speed.slope(place_of[p]), root = root_of(b);
      const Lanes by_b = by.at(place_of[p]), by_d = by.slope(place_of[p]), tangent = 0.5 * by_b / b;
      for (std::size_t a = 0; a < moving_.size(); ++a) {
        float* const of = of_axis(block, a);
        const Lanes x1(of + shape_row(p) * lanes), x2(of + shape_row(p) * lanes + lanes), x3(of + shape_row(p) * lanes + 2 * lanes);
        const Lanes c = root * (x3 * b + 1.5 * x2 * d + x1 * bend);
        gap += Pairs<Lanes>(of + jerk_row(p) * lanes).move(c, root * (x3 * by_b + 1.5 * x2 * by_d + x1 * by_bend), tangent, mu);
        look_at(c);
        if (p == 0) continue;
        const Lanes e = moving_[a].ratio * (x2 * b + 0.5 * x1 * d);
        gap += Pairs<Lanes>(of + acceleration_row(p) * lanes).move(e, moving_[a].ratio * (x2 * by_b + 0.5 * x1 * by_d), {}, mu);
        look_at(e);
      }
    }
    const Lanes by_cap(of_block + inverse_cap * lanes), slack(of_block + cap_slack * lanes), dual(of_block + cap_dual * lanes);
    const Lanes c = 1 - speed.o1 * by_cap, change = c - slack - by.o1 * by_cap;
    const Lanes new_dual = Pairs<Lanes>::moved_dual(dual, (mu - dual * change) / slack, mu),
                new_slack = Pairs<Lanes>::moved_slack(slack, change);
    new_dual.to(of_block + cap_dual * lanes), new_slack.to(of_block + cap_slack * lanes);
    gap = is_limited * gap + new_dual * new_slack;
    worst = lesser(worst, c);
    const Lanes share = by.o1 / speed.o1, size = greater(share, -share);
    all_worst = lesser(all_worst, worst), all_steps = greater(all_steps, size), all_gaps = greater(all_gaps, gap);
    const bool is_apart = greatest_of(gap) > max_gap * mu * limits_of_cell();
    restless_[block] = least_of(worst) < -max_excess || greatest_of(size) > at_rest || is_apart ? 1 : 0;
  }
  return {least_of(all_worst), greatest_of(all_steps), greatest_of(all_gaps) / (mu * limits_of_cell())};
}

template <class Lanes>
KADR_LANES void PrimalDual::move(const Range& range) {
  for (std::size_t i = range.first * lanes; i < range.end * lanes; i += lanes) {
    const Lanes m(&m_[i]);
    (m + lesser(greater(Lanes(&step_[i]), max_fall * m), most_rise * m)).to(&m_[i]);
  }
}

/// Checks the limits of every cell at sixteen more positions. If a limit is exceeded, the limits of the cell are tightened by `tighter`
/// times the excess.
///   returns  the greatest acceleration or jerk, as a fraction of its limit
template <class Lanes>
KADR_LANES double PrimalDual::look(const Range& range, int tighter) {
  constexpr std::array<double, 16> between = {0, 0.04, 0.1, 0.16, 0.22, 0.28, 0.34, 0.4, 0.6, 0.66, 0.72, 0.78, 0.84, 0.9, 0.96, 1};
  constexpr double a_little_more = 1.005;
  Lanes greatest = {};
  for (std::size_t block = range.first; block < range.end; ++block) {
    const double* const of_block = row(block, length);
    const BlockSpeed<Lanes> speed(of_block, &m_[block * lanes], false);
    const Lanes is_limited(of_block + limited * lanes), h(of_block + length * lanes), bend = speed.half_bend();
    Lanes worst = {};
    for (const double t : between) {
      const Lanes b = greater(speed.at(t), Lanes{}), d = speed.slope(t), root = root_of(b), s = t * h;
      for (std::size_t a = 0; a < moving_.size(); ++a) {
        const float* const c = of_axis(block, a) + polynomial_row * lanes;
        const Lanes c1(c), c2(c + lanes), c3(c + 2 * lanes), c4(c + 3 * lanes), c5(c + 4 * lanes);
        const Lanes x1 = c1 + s * (2 * c2 + s * (3 * c3 + s * (4 * c4 + s * (5 * c5))));
        const Lanes x2 = 2 * c2 + s * (6 * c3 + s * (12 * c4 + s * (20 * c5))), x3 = 6 * c3 + s * (24 * c4 + s * (60 * c5));
        const Lanes jerk = (moving_[a].by_jerk * margins.jerk) * root * (x1 * bend + 1.5 * x2 * d + x3 * b);
        const Lanes acceleration = (moving_[a].by_jerk * moving_[a].ratio * margins.acceleration) * (0.5 * x1 * d + x2 * b);
        worst = greater(worst, greater(greater(jerk, -jerk), greater(acceleration, -acceleration)));
      }
    }
    worst *= is_limited;
    greatest = greater(greatest, worst);
    const bool is_beyond = greatest_of(worst) > allowed;
    restless_[block] = is_beyond ? 1 : 0;
    if (!is_beyond || tighter == 0) continue;
    const Lanes more =
        where_positive(worst - Lanes::all(allowed),
                       Lanes::all(1) + static_cast<double>(tighter) * ((a_little_more / allowed) * worst - Lanes::all(1)), Lanes::all(1));
    for (std::size_t a = 0; a < moving_.size(); ++a)
      for (std::size_t shape = 0; shape < 3 * places; ++shape) {
        float* const x = of_axis(block, a) + shape * lanes;
        (more * Lanes(x)).to(x);
      }
  }
  return greatest_of(greatest);
}

void PrimalDual::fill() {
  with_best_lanes([&](auto like) __attribute__((always_inline)) { fill_shapes<decltype(like)>(); });
}

void PrimalDual::begin(const Range& range, double mu) {
  with_best_lanes([&](auto like) __attribute__((always_inline)) { begin_duals<decltype(like)>(range, mu); });
}

void PrimalDual::derive(const Range& range, double mu) {
  with_best_lanes([&](auto like) __attribute__((always_inline)) { build<decltype(like)>(range, mu); });
  // The contributions of the two cells next to the range are set to 0, because these cells keep their speeds.
  const std::size_t outside[] = {range.first * lanes - 1, range.end * lanes};
  for (const std::size_t i : outside)
    for (auto* const all :
         {&products_[0], &products_[1], &products_[2], &products_[3], &products_[4], &products_[5], &slopes_[0], &slopes_[1], &slopes_[2]})
      (*all)[i] = 0;
  with_best_lanes([&](auto like) __attribute__((always_inline)) { gather<decltype(like)>(range); });
}

PrimalDual::Progress PrimalDual::go(const Range& range, double mu) {
  Progress progress;
  with_best_lanes([&](auto like) __attribute__((always_inline)) {
    progress = update<decltype(like)>(range, mu);
    move<decltype(like)>(range);
  });
  return progress;
}

double PrimalDual::greatest_share(const Range& range, int tighter) {
  double share = 0;
  with_best_lanes([&](auto like) __attribute__((always_inline)) { share = look<decltype(like)>(range, tighter); });
  return share;
}

}  // namespace kadr
