// The fast least-time solver, compared with the safe one and with the closed form.

#include "motion/least_time/primal_dual.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "motion/least_time/least_time.h"
#include "motion/least_time/path_timer.h"
#include "motion/least_time/rest_to_rest.h"
#include "motion/least_time/timed_cells.h"

namespace kadr::primal_dual_test {
namespace {

double seconds(const TimedPath& path, const std::vector<CellSpeeds>& speeds) {
  double sum = 0;
  for (std::size_t k = 0; k < path.cells(); ++k) {
    const PathSpeed from = speeds[k].start, to = speeds[k].end;
    if (k == 0 || k + 1 == path.cells()) sum += 3 * path.h[k] / std::sqrt(k == 0 ? to.b : from.b);
    else sum += TimeLaw::of_squares(path.h[k], std::sqrt(from.b), from.d / 2, (to.d - from.d) / (2 * path.h[k])).seconds;
  }
  return sum;
}

/// Returns cells that grow from both ends; along the path each axis follows a sine of its own size.
TimedPath waves(double length, std::size_t axes, double most, double amplitude, double wave) {
  TimedPath path;
  path.axes = axes;
  path.acceleration.assign(axes, 1000);
  path.jerk.assign(axes, 20000);
  for (double s = 0; s < length;) {
    double h = std::min(0.5, 0.01 + 0.1 * std::min(s, std::max(0.0, length - s)));
    if (s + 1.5 * h >= length) h = length - s;
    path.h.push_back(h);
    path.most.push_back(most);
    path.turns.push_back(0);
    double* const c = path.add_shapes();
    for (std::size_t a = 0; a < axes; ++a) {
      const double w = (1 + 0.3 * static_cast<double>(a)) / wave, r = amplitude / w;  // x′ = c1 + amplitude sin
      const double sine = std::sin(w * s), cosine = std::cos(w * s);
      const double terms[] = {0,
                              0.6 + amplitude * sine,
                              amplitude * w * cosine / 2,
                              -amplitude * w * w * sine / 6,
                              -amplitude * w * w * w * cosine / 24,
                              r * w * w * w * w * w * sine / 120};
      std::copy(std::begin(terms), std::end(terms), c + a * TimedPath::terms);
    }
    s += h;
  }
  return path;
}

TEST(PrimalDual, ALineTakesTheTimeOfTheClosedForm) {
  for (const double speed : {30.0, 200.0})
    for (const double length : {3.0, 20.0, 200.0}) {
      const TimedPath path = waves(length, 1, speed * speed, 0, 1);
      PrimalDual solver;
      ASSERT_TRUE(solver.solve(path, {}));
      std::vector<TimeLaw> laws;
      rest_to_rest(length, {speed, 1000 / 0.6, 20000 / 0.6}, laws);
      double exact = 0;
      for (const TimeLaw& law : laws) exact += law.seconds;
      EXPECT_GE(seconds(path, solver.speeds()), exact * (1 - 1e-9));
      EXPECT_LE(seconds(path, solver.speeds()), exact * 1.03);
    }
}

RC_GTEST_PROP(PrimalDualProperty, IsAsQuickAsTheSureSolver, ()) {
  const double length = *rc::gen::inRange(5, 100), feed = *rc::gen::inRange(5, 200);
  const TimedPath path = waves(length, static_cast<std::size_t>(*rc::gen::inRange(1, 6)), feed * feed, *rc::gen::inRange(0, 60) * 0.01,
                               *rc::gen::inRange(5, 100) * 0.1);
  PrimalDual quick;
  LeastTime sure;
  RC_ASSERT(quick.solve(path, {}));
  RC_ASSERT(sure.solve(path, {}));
  const double one = seconds(path, quick.speeds()), two = seconds(path, sure.speeds());
  RC_ASSERT(one <= 1.01 * two);
  for (std::size_t k = 0; k < path.cells(); ++k) {
    RC_ASSERT(quick.speeds()[k].start.b <= path.most[k] * 1.001);
    if (k > 0) RC_ASSERT(std::fabs(quick.speeds()[k].start.b - quick.speeds()[k - 1].end.b) <= 1e-9 * path.most[k]);
    if (k > 1) RC_ASSERT(std::fabs(quick.speeds()[k].start.d - quick.speeds()[k - 1].end.d) <= 1e-6 * path.most[k] / path.h[k]);
  }
}

// Where the path reverses, the axes stop for an instant: b is 0, and b′ changes its sign.
TEST(PrimalDual, TurnsBackInMotion) {
  TimedPath path = waves(40, 1, 1e4, 0, 1);
  const std::size_t half = path.cells() / 2;
  path = path.first(half);
  const TimedPath there = path;
  path.turns.back() = 1;
  for (std::size_t k = half; k-- > 0;) {
    path.h.push_back(there.h[k]);
    path.most.push_back(there.most[k]);
    path.turns.push_back(0);
    double* const c = path.add_shapes();
    std::copy(there.shape(k, 0), there.shape(k, 0) + TimedPath::terms, c);
    c[1] = -c[1];
  }
  PathTimer timer;
  ASSERT_TRUE(timer.solve(path, {}));
  EXPECT_EQ(timer.work().by_sure_one, 0U);
  EXPECT_EQ(timer.speeds()[half - 1].end.b, 0);
  EXPECT_NEAR(timer.speeds()[half - 1].end.d, -timer.speeds()[half].start.d, 1e-9 * std::fabs(timer.speeds()[half].start.d));
}

TEST(PrimalDual, WithoutALimitThatCanBeKeptThereIsNone) {
  TimedPath path = waves(10, 1, 1e4, 0, 1);
  path.most[path.cells() / 2] = 0;
  EXPECT_FALSE(PathTimer().solve(path, {}));
  path = waves(10, 1, 1e4, 0, 1);
  path.shapes[path.shapes.size() / 2 + 2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(PathTimer().solve(path, {}));
}

// If it is requested to stop, the solver returns no solution and reports this.
TEST(PrimalDual, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  EXPECT_FALSE(PathTimer().solve(waves(100, 3, 1e4, 0.3, 1), {}, StopToken(stop)));
}

}  // namespace
}  // namespace kadr::primal_dual_test
