// The least-time planner: its output obeys every limit, follows the path within the tolerance, and is as fast as can be proved.

#include "motion/least_time/planner.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "planned_run.h"

namespace kadr::planner_test {
namespace {

using test::Piece;
using test::PlannedRun;
using test::Point;

constexpr double speed = 200, acceleration = 1000, jerk = 20000;

PlannedRun planned(const std::vector<Piece>& pieces, const Point& start = {}) {
  return test::planned_run(test::three_axes(speed, acceleration, jerk), pieces, start);
}

double away(const Point& p, const Point& a, const Point& b) {
  double square = 0, along = 0, off = 0;
  for (std::size_t i = 0; i < 3; ++i) square += (b[i] - a[i]) * (b[i] - a[i]), along += (p[i] - a[i]) * (b[i] - a[i]);
  const double part = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  for (std::size_t i = 0; i < 3; ++i) off += std::pow(p[i] - a[i] - part * (b[i] - a[i]), 2);
  return std::sqrt(off);
}

double furthest(const PlannedRun& run, const std::vector<Piece>& pieces, const Point& start = {}) {
  double worst = 0;
  for (const Point& p : run.points) {
    double least = 1e300;
    Point from = start;
    for (const Piece& piece : pieces) least = std::min(least, away(p, from, piece.to)), from = piece.to;
    worst = std::max(worst, least);
  }
  return worst;
}

void expect_within_limits(const PlannedRun& run) {
  constexpr double over = 1.001;  // allows for the rounding of differences of doubles
  EXPECT_LE(run.speed, speed * over);
  EXPECT_LE(run.acceleration, acceleration * over);
  EXPECT_LE(run.jerk, jerk * over);
  EXPECT_EQ(run.failures, 0U);
}

// nct 7.0: L ≥ 2 F (F/a + T)/2, T = a/j: t = F/a + T + L/F
TEST(Planner, ALineFromRestToRestTakesTheClosedFormsTime) {
  const PlannedRun run = planned({{{40, 0, 0}, 100, 0}});
  EXPECT_NEAR(run.seconds, 0.1 + 0.05 + 0.4, 1e-9);
  expect_within_limits(run);
}

TEST(Planner, AShortLineDoesNotReachTheAcceleration) {
  EXPECT_NEAR(planned({{{0.02, 0, 0}, 100, 0}}).seconds, std::cbrt(32 * 0.02 / jerk), 1e-9);
}

TEST(Planner, WithoutToleranceItStopsAtEachCorner) {
  const PlannedRun run = planned({{{40, 0, 0}, 100, 0}, {{40, 25, 0}, 100, 0}});
  EXPECT_NEAR(run.seconds, 0.55 + 0.4, 1e-9);
  EXPECT_LT(furthest(run, {{{40, 0, 0}, 0, 0}, {{40, 25, 0}, 0, 0}}), 1e-9);
}

// A reversal on the same line without a stop: one change of speed from +v to −v takes 2 v/a + a/j, two ramps take 2 (v/a + a/j). At 100
// mm/s this saves 0.05 s of 1.1 s; the distance travelled meanwhile is the same.
TEST(Planner, TurningBackTakesOneChangeOfSpeed) {
  const PlannedRun run = planned({{{40, 0, 0}, 100, 0.01}, {{0, 0, 0}, 100, 0.01}});
  EXPECT_LT(run.seconds, 1.06);
  EXPECT_GT(run.seconds, 1.04);
  double most = 0;
  for (const Point& p : run.points) most = std::max(most, p[0]);
  EXPECT_NEAR(most, 40, 1e-3);
  expect_within_limits(run);
}

TEST(Planner, ACornerIsFasterThanAStopAndWithinTheTolerance) {
  const std::vector<Piece> corner{{{40, 0, 0}, 100, 0.01}, {{40, 25, 0}, 100, 0.01}};
  const PlannedRun run = planned(corner);
  EXPECT_LT(run.seconds, 0.95);
  EXPECT_LE(furthest(run, corner), 0.01);
  expect_within_limits(run);
}

TEST(Planner, MoreToleranceIsNotSlower) {
  double before = 1e9;
  for (const double tolerance : {0.001, 0.01, 0.1, 0.5}) {
    std::vector<Piece> square;
    for (int i = 0; i < 3; ++i)
      for (const Point to : {Point{40, 0, 0}, {40, 25, 0}, {0, 25, 0}, {0, 0, 0}}) square.push_back({to, 100, tolerance});
    const double now = planned(square).seconds;
    EXPECT_LE(now, before * (1 + 1e-9));
    before = now;
  }
}

// A circle of short lines at a feed that its acceleration allows: it takes
// the time of the path at its feed, apart from the start and the end.
TEST(Planner, AChainOfShortLinesIsNotSlowedByItsCorners) {
  std::vector<Piece> circle;
  constexpr int pieces = 2000;
  constexpr double radius = 20, feed = 50;
  for (int i = 1; i <= pieces; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / pieces;
    circle.push_back({{radius * std::sin(angle), radius * (1 - std::cos(angle)), 0}, feed, 0.01});
  }
  const PlannedRun run = planned(circle);
  const double path_length = 2 * 3.14159265358979323846 * radius;
  EXPECT_LT(run.seconds, path_length / feed + 0.12);
  EXPECT_LE(furthest(run, circle), 0.01);
  expect_within_limits(run);
}

// 200 m at 0.5 mm/s: the plan has as few cells as for any other line, not one for each 0.01 s.
TEST(Planner, AVeryLongSlowLineTakesFewCells) {
  std::size_t cells = 0;
  double seconds = 0;
  Planner planner(test::three_axes(speed, acceleration, jerk), [&](const TimedCells& timed) {
    cells += timed.laws.size();
    seconds += timed.seconds();
  });
  planner.begin(Point{}.data());
  planner.line_to(Point{1e5, 0, 0}.data(), 0.5, 0.01, false, 0);
  planner.line_to(Point{1e5, 1e5, 0}.data(), 0.5, 0.01, false, 0);
  planner.stop();
  EXPECT_LT(cells, 1000U);
  EXPECT_NEAR(seconds / 4e5, 1, 1e-3);
  EXPECT_EQ(planner.failures(), 0U);
}

TEST(Planner, AWindowMuchShorterThanThePathCostsNoTime) {
  std::vector<Piece> chain;
  for (int i = 1; i <= 20000; ++i) chain.push_back({{i * 0.05, 0.2 * std::sin(i * 0.01), 0}, 80, 0.01});
  const PlannedRun run = planned(chain);
  EXPECT_LT(run.seconds, 1000.0 / 80 * 1.0005 + 0.15);
  expect_within_limits(run);
}

/// Random segments with one tolerance, or with several.
std::vector<Piece> random_pieces(bool mixed) {
  std::vector<Piece> pieces;
  Point at{};
  const int kind = *rc::gen::inRange(0, 3), count = *rc::gen::inRange(2, 60);
  double heading = 0;
  const double tolerance = *rc::gen::element(0.005, 0.02, 0.1);
  for (int i = 0; i < count; ++i) {
    const double step = kind == 0 ? *rc::gen::inRange(10, 500) * 1e-3 : *rc::gen::inRange(1, 400) * 0.1;
    heading += kind == 0 ? *rc::gen::inRange(-100, 101) * 2e-3 : *rc::gen::inRange(0, 361) * 3.14159265358979323846 / 180;
    at = {at[0] + step * std::cos(heading), at[1] + step * std::sin(heading), at[2] + (*rc::gen::inRange(0, 5) == 0 ? 0.3 : 0.0)};
    pieces.push_back({at, *rc::gen::inRange(1, 200) * 1.0, mixed ? *rc::gen::element(0.005, 0.02, 0.1) : tolerance});
  }
  return pieces;
}

RC_GTEST_PROP(PlannerProperty, ObeysEveryLimitAndFollowsThePath, ()) {
  const std::vector<Piece> pieces = random_pieces(true);
  const PlannedRun run = planned(pieces);
  constexpr double over = 1.002;
  RC_ASSERT(run.failures == 0U);
  RC_ASSERT(run.speed <= speed * over);
  RC_ASSERT(run.acceleration <= acceleration * over);
  RC_ASSERT(run.jerk <= jerk * 1.01);  // the jerk is checked at sampled positions only: docs/planner.md
  double most = 0;
  for (const Piece& piece : pieces) most = std::max(most, piece.tolerance);
  RC_ASSERT(furthest(run, pieces) <= most * 1.005);  // checked at sampled positions only
  for (std::size_t a = 0; a < 3; ++a) RC_ASSERT(std::fabs(run.end[a] - pieces.back().to[a]) < 1e-9);
}

// The plans are not equal bit by bit: the cells are at other positions,
// and another of several good speeds may be found. Tiny paths differ most.
constexpr double some = 0.07;  // s

RC_GTEST_PROP(PlannerProperty, ASplitLineTakesTheSameTime, ()) {
  std::vector<Piece> pieces = random_pieces(false), split;
  Point from{};
  for (const Piece& piece : pieces) {
    const double part = *rc::gen::inRange(1, 100) * 0.01;
    Piece half = piece;
    for (std::size_t a = 0; a < 3; ++a) half.to[a] = from[a] + part * (piece.to[a] - from[a]);
    split.push_back(half);
    split.push_back(piece);
    from = piece.to;
  }
  const double one = planned(pieces).seconds, two = planned(split).seconds;
  RC_ASSERT(std::fabs(one - two) <= 0.1 * one + some);
}

RC_GTEST_PROP(PlannerProperty, BackwardsItTakesTheSameTime, ()) {
  const std::vector<Piece> pieces = random_pieces(false);
  std::vector<Piece> back;
  for (std::size_t i = pieces.size(); i-- > 0;)
    back.push_back({i > 0 ? pieces[i - 1].to : Point{}, pieces[i].feed, i + 1 < pieces.size() ? pieces[i + 1].tolerance : 0.01});
  const double one = planned(pieces).seconds, two = planned(back, pieces.back().to).seconds;
  RC_ASSERT(std::fabs(one - two) <= 0.1 * one + some);
}

}  // namespace
}  // namespace kadr::planner_test
