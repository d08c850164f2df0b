// The least-time planner stops when it is requested to, and where it has no plan; after that it emits nothing more.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "motion/least_time/rest_to_rest.h"
#include "planned_run.h"

namespace kadr::planner_end_test {
namespace {

using test::Point;

const MotionLimits limits = test::three_axes(200, 1000, 20000);

/// What the planner has emitted.
struct Handed {
  std::size_t times = 0, cells = 0;
  double seconds = 0;
};

TEST(PlannerEnd, AskedToStopItHandsOutNothing) {
  std::atomic<bool> flag{true};
  Handed handed;
  Planner planner(limits, [&](const TimedCells&) { ++handed.times; });
  planner.stop_by(StopToken(flag));
  planner.begin(Point{}.data());
  planner.line_to(Point{10, 0, 0}.data(), 50, 0.01, false, 1);
  planner.stop();
  EXPECT_EQ(handed.times, 0U);
  EXPECT_EQ(planner.ended(), PlanEnd::stopped);
}

// The stop is requested by the receiver of the first of many windows.
TEST(PlannerEnd, AskedToStopOnTheWayItHandsOutNothingMore) {
  std::atomic<bool> flag{false};
  Handed handed;
  Planner planner(limits, [&](const TimedCells&) {
    ++handed.times;
    flag = true;
  });
  planner.stop_by(StopToken(flag));
  planner.begin(Point{}.data());
  for (int i = 1; i <= 20000; ++i) planner.line_to(Point{i * 0.1, std::sin(i * 0.05), 0}.data(), 50, 0.01, false, 1);
  planner.stop();
  EXPECT_EQ(handed.times, 1U);
  EXPECT_EQ(planner.ended(), PlanEnd::stopped);
}

// A path that never ends takes longer than any other.
TEST(PlannerEnd, WhatIsNoPlanIsNotHandedOut) {
  Handed handed;
  Planner planner(limits, [&](const TimedCells& cells) {
    ++handed.times;
    handed.seconds += cells.seconds();
  });
  planner.begin(Point{}.data());
  planner.line_to(Point{10, 0, 0}.data(), 50, 0.01, false, 1);
  planner.stop();
  EXPECT_EQ(planner.ended(), PlanEnd::none);
  planner.line_to(Point{1e200, 0, 0}.data(), 50, 0.01, false, 2);
  planner.stop();
  EXPECT_EQ(planner.ended(), PlanEnd::too_slow);
  EXPECT_EQ(planner.refused().tag, 2U);
  planner.begin(Point{}.data());
  planner.line_to(Point{10, 0, 0}.data(), 50, 0.01, false, 3);
  planner.stop();
  EXPECT_EQ(handed.times, 1U);
  EXPECT_NEAR(handed.seconds, 0.2 + 0.05 + 0.05, 1e-9);  // nct 7.0: L/F + F/a + a/j
}

// 1 nm at 1 nm/s takes one second; a cell of a hundredth of a millimetre at this feed would take three hours.
TEST(PlannerEnd, AShortSlowPieceSlowsNotWhatIsBesideIt) {
  Handed handed;
  Planner planner(limits, [&](const TimedCells& cells) { handed.seconds += cells.seconds(); });
  planner.begin(Point{}.data());
  planner.line_to(Point{10, 0, 0}.data(), 50, 0.01, false, 1);
  planner.line_to(Point{10 + 1e-6, 0, 0}.data(), 1e-6, 0.01, false, 2);
  planner.line_to(Point{20, 0, 0}.data(), 50, 0.01, false, 3);
  planner.stop();
  EXPECT_EQ(planner.ended(), PlanEnd::none);
  EXPECT_NEAR(handed.seconds, 1 + 2 * (0.2 + 0.1), 0.05);
}

TEST(PlannerEnd, TheTimeFromRestToRestIsThatOfItsPhases) {
  for (const double length : {1e-9, 1e-5, 0.01, 1.0, 100.0})
    for (const LineLimits& line : {LineLimits{50, 1000, 20000}, {1e-6, 400, 8000}, {1e6, 1000, std::numeric_limits<double>::infinity()}}) {
      std::vector<TimeLaw> phases;
      rest_to_rest(length, line, phases);
      double seconds = 0;
      for (const TimeLaw& phase : phases) seconds += phase.seconds;
      EXPECT_NEAR(rest_to_rest_s(length, line) / seconds, 1, 1e-9);
    }
}

}  // namespace
}  // namespace kadr::planner_end_test
