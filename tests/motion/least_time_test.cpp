// The least-time solver on a path with a known answer, and on paths that have no solution.

#include "motion/least_time/least_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "motion/least_time/rest_to_rest.h"
#include "motion/least_time/timed_cells.h"

namespace kadr::least_time_test {
namespace {

/// Returns a straight line of one axis; its cells grow from both ends.
TimedPath line(double length, double speed, double acceleration, double jerk) {
  TimedPath path;
  path.axes = 1;
  path.acceleration = {acceleration};
  path.jerk = {jerk};
  for (double s = 0; s < length;) {
    double h = 0.005 + 0.1 * std::min(s, std::max(0.0, length - s));
    if (s + 1.5 * h >= length) h = length - s;
    path.h.push_back(h);
    path.most.push_back(speed * speed);
    path.turns.push_back(0);
    path.shapes.insert(path.shapes.end(), {s, 1, 0, 0, 0, 0});
    s += h;
  }
  return path;
}

double seconds(const TimedPath& path, const LeastTime& solved) {
  double sum = 0;
  const std::size_t n = path.cells();
  for (std::size_t k = 0; k < n; ++k) {
    const PathSpeed from = solved.speeds()[k].start, to = solved.speeds()[k].end;
    if (k == 0 || k + 1 == n) sum += 3 * path.h[k] / std::sqrt(k == 0 ? to.b : from.b);
    else sum += TimeLaw::of_squares(path.h[k], std::sqrt(from.b), from.d / 2, (to.d - from.d) / (2 * path.h[k])).seconds;
  }
  return sum;
}

double closed_form(double length, const LineLimits& limits) {
  std::vector<TimeLaw> laws;
  rest_to_rest(length, limits, laws);
  double sum = 0;
  for (const TimeLaw& law : laws) sum += law.seconds;
  return sum;
}

class ALine : public testing::TestWithParam<std::array<double, 2>> {};

TEST_P(ALine, TakesTheTimeOfTheClosedForm) {
  const auto [length, speed] = GetParam();
  const TimedPath path = line(length, speed, 1000, 20000);
  LeastTime solver;
  ASSERT_TRUE(solver.solve(path, {}));
  const double exact = closed_form(length, {speed, 1000, 20000}), found = seconds(path, solver);
  EXPECT_GE(found, exact * (1 - 1e-9));  // nothing can be faster
  EXPECT_LE(found, exact * 1.026);       // margins of the limits (0.9 %), and the effect of the cells
}

INSTANTIATE_TEST_SUITE_P(Lines, ALine,
                         testing::Values(std::array{0.5, 200.0}, std::array{3.0, 200.0}, std::array{20.0, 200.0}, std::array{20.0, 30.0},
                                         std::array{200.0, 100.0}));

TEST(LeastTime, ASlowerCellSlowsItsNeighboursOnlyAsFarAsLimitsDemand) {
  TimedPath path = line(100, 100, 1000, 20000);
  LeastTime solver;
  ASSERT_TRUE(solver.solve(path, {}));
  const double free = seconds(path, solver);
  double s = 0;
  for (std::size_t k = 0; k < path.cells(); s += path.h[k++])
    if (s > 45 && s < 55) path.most[k] = 20 * 20;
  ASSERT_TRUE(solver.solve(path, {}));
  const double slow = seconds(path, solver);
  EXPECT_GT(slow, free + 10 / 20.0 - 10 / 100.0);
  EXPECT_LT(slow, free + 14 / 20.0 + 0.3);
  for (std::size_t k = 0; k < path.cells(); ++k) EXPECT_LE(solver.speeds()[k].start.b, path.most[k] * (1 + 1e-9));
}

TEST(LeastTime, WithoutALimitThatCanBeKeptThereIsNone) {
  TimedPath path = line(10, 100, 1000, 20000);
  path.most[path.cells() / 2] = 0;
  LeastTime solver;
  EXPECT_FALSE(solver.solve(path, {}));
  path = line(10, 100, 1000, 20000);
  path.shapes[path.shapes.size() / 2 + 2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solver.solve(path, {}));
}

// From any speed in the middle of a solution, the rest takes no longer than in that solution.
TEST(LeastTime, GoesOnFromAnEarlierSolution) {
  const TimedPath path = line(60, 100, 1000, 20000);
  LeastTime solver;
  ASSERT_TRUE(solver.solve(path, {}));
  const std::size_t from = path.cells() / 3;
  PathEnds ends;
  ends.from_stop = false;
  ends.from = solver.speeds()[from].start;
  ends.guess.assign(solver.middles().begin() + static_cast<std::ptrdiff_t>(from), solver.middles().end());
  TimedPath rest;
  rest.axes = 1;
  rest.acceleration = path.acceleration;
  rest.jerk = path.jerk;
  for (std::size_t k = from; k < path.cells(); ++k) {
    rest.h.push_back(path.h[k]);
    rest.most.push_back(path.most[k]);
    rest.turns.push_back(0);
    rest.shapes.insert(rest.shapes.end(), path.shape(k, 0), path.shape(k, 0) + TimedPath::terms);
  }
  const auto before = solver.speeds();
  ASSERT_TRUE(solver.solve(rest, ends));
  EXPECT_EQ(solver.speeds()[0].start.b, ends.from.b);
  for (std::size_t k = 1; k < rest.cells(); ++k) EXPECT_NEAR(solver.speeds()[k].start.b, before[from + k].start.b, 0.05 * 100 * 100);
}

}  // namespace
}  // namespace kadr::least_time_test
