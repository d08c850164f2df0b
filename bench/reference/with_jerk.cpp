#include "with_jerk.h"

#include <algorithm>
#include <cmath>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpSolveStatistics.hpp>
#include <coin/IpTNLP.hpp>

#include "jet.h"

namespace kadr::reference {
namespace {

using Ipopt::Index;
using Ipopt::Number;

constexpr Index near = 5;  // number of variables that an interval depends on: its own v a t, and v a of the next interval
constexpr Number boundless = 1e20;
using NearJet = Jet<static_cast<std::size_t>(near)>;

constexpr std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// The optimisation problem in the form of Ipopt. The variables are v a t, v a t, … v a, divided by the mean speed of the start motion,
/// by the acceleration limit, and by the time of the start motion.
class Programme : public Ipopt::TNLP {
 public:
  Programme(const Grid& grid, const MotionLimits& limits, const PathMotion& start) : grid_(grid), limits_(limits), start_(start) {
    speed_ = limits.speed[0];
    acceleration_ = limits.acceleration[0];
    for (std::size_t k = 0; k < grid.intervals(); ++k) {
      first_row_.push_back(rows_);
      rows_ += equations;
      for (std::size_t a = 0; a < limits.speed.size(); ++a)
        if (moves(k, a)) rows_ += k > 0 ? 3 : 2;
    }
    first_row_.push_back(rows_);
  }

  const std::optional<PathMotion>& found() const { return found_; }

  bool get_nlp_info(Index& n, Index& m, Index& of_jacobian, Index& of_hessian, IndexStyleEnum& style) override {
    n = variables();
    m = rows_;
    of_jacobian = rows_ * near;
    of_hessian = intervals() * near * (near + 1) / 2;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* low, Number* high, Index m, Number* row_low, Number* row_high) override {
    constexpr double least_time = 1e-3, most_time = 1e3;  // bounds of t, in units of the start motion's time
    std::fill_n(row_low, m, -1.0);
    std::fill_n(row_high, m, 1.0);
    for (Index k = 0; k <= intervals(); ++k) {
      const bool rests = k == 0 || k == intervals();
      low[3 * k] = 0;
      high[3 * k] = rests ? 0 : std::sqrt(grid_.most(at(k))) / speed_;
      low[3 * k + 1] = rests ? 0 : -boundless;
      high[3 * k + 1] = rests ? 0 : boundless;
      if (3 * k + 2 >= n) continue;
      low[3 * k + 2] = least_time;
      high[3 * k + 2] = most_time;
      for (Index row = 0; row < equations; ++row) row_low[first_row_[at(k)] + row] = row_high[first_row_[at(k)] + row] = 0;
    }
    return true;
  }

  bool get_starting_point(Index, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    for (Index k = 0; k <= intervals(); ++k) {
      x[3 * k] = start_.v[at(k)] / speed_;
      x[3 * k + 1] = start_.a[at(k)] / acceleration_;
      if (k < intervals()) x[3 * k + 2] = 1;
    }
    return true;
  }

  bool eval_f(Index, const Number* x, bool, Number& value) override {
    value = 0;
    for (Index k = 0; k < intervals(); ++k) value += weight(k) * x[3 * k + 2];
    return true;
  }

  bool eval_grad_f(Index n, const Number*, bool, Number* gradient) override {
    std::fill_n(gradient, n, 0.0);
    for (Index k = 0; k < intervals(); ++k) gradient[3 * k + 2] = weight(k);
    return true;
  }

  bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
    for (Index k = 0; k < intervals(); ++k) rows_of(k, x + 3 * k, [&](const double& row) { *g++ = row; });
    return true;
  }

  bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* rows, Index* columns, Number* values) override {
    for (Index k = 0; k < intervals(); ++k) {
      if (values == nullptr) {
        for (Index row = first_row_[at(k)]; row < first_row_[at(k) + 1]; ++row)
          for (Index i = 0; i < near; ++i) *rows++ = row, *columns++ = 3 * k + i;
      } else {
        rows_of(k, jets(k, x).data(), [&](const NearJet& row) { values = std::copy(row.by.begin(), row.by.end(), values); });
      }
    }
    return true;
  }

  bool eval_h(Index, const Number* x, bool, Number, Index, const Number* lambda, bool, Index, Index* rows, Index* columns,
              Number* values) override {
    for (Index k = 0; k < intervals(); ++k) {
      NearJet sum;
      if (values != nullptr) rows_of(k, jets(k, x).data(), [&](const NearJet& row) { sum = sum + NearJet(*lambda++) * row; });
      for (Index i = 0; i < near; ++i)
        for (Index j = 0; j <= i; ++j) {
          if (values != nullptr) *values++ = sum.bend[at(i)][at(j)];
          else *rows++ = 3 * k + i, *columns++ = 3 * k + j;
        }
    }
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number* x, const Number*, const Number*, Index m, const Number* g, const Number*,
                         Number, const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    constexpr double kept = 1e-5;  // relative error up to which a limit counts as kept
    for (Index i = 0, k = 0; i < m; ++i) {
      while (first_row_[at(k) + 1] <= i) ++k;
      if (std::fabs(g[i]) > kept + (i - first_row_[at(k)] < equations ? 0 : 1)) return;
    }
    PathMotion& motion = found_.emplace();
    for (Index k = 0; k <= intervals(); ++k) {
      motion.v.push_back(x[3 * k] * speed_);
      motion.a.push_back(x[3 * k + 1] * acceleration_);
      if (k < intervals()) motion.seconds.push_back(x[3 * k + 2] * start_.seconds[at(k)]);
    }
  }

 private:
  static constexpr Index equations = 2;
  Index intervals() const { return static_cast<Index>(grid_.intervals()); }
  Index variables() const { return 3 * intervals() + 2; }
  /// Weight of an interval in the sum that is minimised: 1 on average, so that Ipopt's tolerances have a meaning.
  double weight(Index k) const { return start_.seconds[at(k)] * intervals() / total_; }

  bool moves(std::size_t k, std::size_t axis) const {
    constexpr double still = 1e-9;
    for (const Place& place : {grid_.start[k], grid_.end[k]})
      if (std::fabs(place.x1[axis]) + std::fabs(place.x2[axis]) + std::fabs(place.x3[axis]) > still) return true;
    return false;
  }

  std::array<NearJet, at(near)> jets(Index k, const Number* x) const {
    std::array<NearJet, at(near)> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = NearJet(x[at(3 * k) + i], i);
    return all;
  }

  /// Calls `take` for each equation and limit of an interval, in order.
  template <class Number, class Take>
  void rows_of(Index interval, const Number* x, const Take& take) const {
    const std::size_t k = at(interval);
    const Number v0 = x[0] * Number(speed_), a0 = x[1] * Number(acceleration_), t = x[2] * Number(start_.seconds[k]),
                 v1 = x[3] * Number(speed_), a1 = x[4] * Number(acceleration_), jerk = (a1 - a0) / t;
    const double h = grid_.h[k];
    take(t * (v0 + (Number(2.0) * a0 + a1) * t * Number(1.0 / 6)) * Number(1 / h) - Number(1.0));
    take((v0 + (a0 + a1) * t * Number(0.5) - v1) * Number(1 / speed_));
    for (std::size_t a = 0; a < limits_.speed.size(); ++a) {
      if (!moves(k, a)) continue;
      const Place &from = grid_.start[k], &to = grid_.end[k];
      const double by_j = 1 / limits_.jerk[a], by_a = 1 / limits_.acceleration[a];
      if (k > 0) take(Number(from.x1[a] * by_a) * a0 + Number(from.x2[a] * by_a) * v0 * v0);
      take(Number(from.x1[a] * by_j) * jerk + v0 * (Number(3 * from.x2[a] * by_j) * a0 + Number(from.x3[a] * by_j) * v0 * v0));
      take(Number(to.x1[a] * by_j) * jerk + v1 * (Number(3 * to.x2[a] * by_j) * a1 + Number(to.x3[a] * by_j) * v1 * v1));
    }
  }

  const Grid& grid_;
  const MotionLimits& limits_;
  const PathMotion& start_;
  double speed_ = 0, acceleration_ = 0, total_ = start_.total();
  Index rows_ = 0;
  std::vector<Index> first_row_;
  std::optional<PathMotion> found_;
};

}  // namespace

std::optional<Found> with_jerk(const Grid& grid, const MotionLimits& limits, const PathMotion& start, double most_seconds) {
  constexpr Index max_steps = 1000;   // 30 to 60 are needed
  constexpr Number tolerance = 1e-5;  // share of the mean interval's time: the greatest time that each limit costs
  constexpr Number first_mu = 1e-2;   // first barrier parameter: far enough from the limits for any start motion
  const Ipopt::SmartPtr<Programme> programme = new Programme(grid, limits, start);
  Ipopt::IpoptApplication solver(false);
  solver.Options()->SetIntegerValue("print_level", 0);
  solver.Options()->SetStringValue("sb", "yes");
  solver.Options()->SetIntegerValue("max_iter", max_steps);
  solver.Options()->SetNumericValue("tol", tolerance);
  solver.Options()->SetNumericValue("mu_init", first_mu);
  solver.Options()->SetNumericValue("max_cpu_time", most_seconds);
  if (solver.Initialize() != Ipopt::Solve_Succeeded) return std::nullopt;
  solver.OptimizeTNLP(GetRawPtr(programme));
  if (!programme->found()) return std::nullopt;
  return Found{*programme->found(), solver.Statistics()->IterationCount()};
}

}  // namespace kadr::reference
