// What limits a cell, in cases where the answer is obvious; and the lines that lose most time by their limits.

#include "motion/look_ahead/limited_by.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/vec.h"
#include "motion/least_time/axis_motion.h"
#include "motion/time/lost_time.h"
#include "motion/time/planned_time.h"

namespace kadr::limited_by_test {
namespace {

using Point = std::array<double, 3>;

/// X has half the acceleration of the other axes.
const MotionLimits limits{{200, 200, 200}, {500, 1000, 1000}, {20000, 20000, 20000}};

struct Seen {
  double from = 0, seconds = 0;  // both in seconds; `from` since the start
  LimitedBy by;
};

class Drive {
 public:
  Drive() : planner_(limits, [this](const TimedCells& cells) { take(cells); }) { planner_.begin(Point{}.data()); }
  Drive(const Drive&) = delete;  // the planner keeps a reference to it
  Drive& operator=(const Drive&) = delete;
  Drive& line(const Point& to, double feed, double tolerance = 0.01, bool on_curve = false) {
    planner_.line_to(to.data(), feed, tolerance, on_curve, tag);
    return *this;
  }
  Drive& stop() {
    planner_.stop();
    return *this;
  }

  Limit at(double instant) const {
    for (const Seen& seen : all)
      if (instant < seen.from + seen.seconds) return seen.by.limit;
    return Limit::pause;
  }
  double seconds() const { return all.back().from + all.back().seconds; }
  /// Returns the time spent at each limit.
  std::map<Limit, double> shares() const {
    std::map<Limit, double> sum;
    for (const Seen& seen : all) sum[seen.by.limit] += seen.seconds;
    return sum;
  }
  std::uint8_t axis_of(Limit limit) const {
    std::map<std::uint8_t, double> sum;
    for (const Seen& seen : all)
      if (seen.by.limit == limit) sum[seen.by.axis] += seen.seconds;
    const auto most = std::max_element(sum.begin(), sum.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == sum.end() ? 99 : most->first;
  }

  std::vector<Seen> all;
  LostTime lost{limits};
  PlannedTime time;
  std::uint64_t tag = Spent{Spent::On::cutting, 1}.tag();

 private:
  void take(const TimedCells& cells) {
    ASSERT_EQ(cells.sources.size(), cells.laws.size());
    for (std::size_t k = 0; k < cells.laws.size(); ++k)
      all.push_back({all.empty() ? 0 : seconds(), cells.laws[k].seconds, limited_by(cells, k, limits)});
    lost.take(cells);
    time.take(cells, limits);
  }
  Planner planner_;
};

// Along X: 25 ms limited by jerk, then 175 ms at 500 mm/s² up to 100 mm/s, and the same back to rest.
TEST(LimitedBy, ALongLineItsFeedInTheMiddleJerkAndAccelerationAtItsEnds) {
  Drive run;
  run.line({200, 0, 0}, 100).stop();
  const double end = run.seconds();
  EXPECT_EQ(run.at(0.01), Limit::jerk);
  EXPECT_EQ(run.at(0.1), Limit::acceleration);
  EXPECT_EQ(run.at(end / 2), Limit::feed);
  EXPECT_EQ(run.at(end - 0.1), Limit::acceleration);
  EXPECT_EQ(run.at(end - 0.01), Limit::jerk);
  EXPECT_EQ(run.axis_of(Limit::acceleration), 0);
}

TEST(LimitedBy, OfTwoAxesTheOneThatIsNearest) {
  EXPECT_EQ(Drive().line({50, 200, 0}, 100).stop().axis_of(Limit::acceleration), 1);
  EXPECT_EQ(Drive().line({200, 150, 0}, 100).stop().axis_of(Limit::acceleration), 0);
}

TEST(LimitedBy, ARapidTheSpeedOfItsAxis) {
  Drive run;
  run.line({0, 400, 300}, 250).stop();  // Y reaches its 200 mm/s
  EXPECT_EQ(run.at(run.seconds() / 2), Limit::axis_speed);
  EXPECT_EQ(run.axis_of(Limit::axis_speed), 1);
}

TEST(LimitedBy, AFeedAboveTheAxisTheSpeedOfTheAxis) {
  Drive run;
  run.line({0, 0, 600}, 300).stop();
  EXPECT_EQ(run.at(run.seconds() / 2), Limit::axis_speed);
  EXPECT_EQ(run.axis_of(Limit::axis_speed), 2);
}

void circle(Drive& run, double radius, double feed) {
  constexpr int chords = 720;
  for (int i = 1; i <= chords; ++i) {
    const double turn = 2 * pi * i / chords;
    run.line({radius * (1 - std::cos(turn)), radius * std::sin(turn), 0}, feed, 0.001, i > 1);
  }
  run.stop();
}

// √(500·10) = 71 mm/s where X reverses.
TEST(LimitedBy, ACircleTooFastForItsAxesTheCurve) {
  Drive run;
  circle(run, 10, 150);
  auto shares = run.shares();
  EXPECT_GT(shares[Limit::curve], 0.4 * run.seconds());  // in the remaining time X and Y accelerate and brake by turns
  EXPECT_GT(shares[Limit::curve] + shares[Limit::jerk] + shares[Limit::acceleration], 0.95 * run.seconds());
  EXPECT_EQ(shares[Limit::corner], 0);
}

TEST(LimitedBy, ASlowCircleItsFeed) {
  Drive run;
  circle(run, 10, 20);
  auto shares = run.shares();
  EXPECT_GT(shares[Limit::feed], 0.9 * run.seconds());
}

TEST(LimitedBy, ACornerWithinItsTolerance) {
  Drive run;
  run.line({0, 40, 0}, 100).line({0, 40, 40}, 100).stop();
  EXPECT_EQ(run.at(run.seconds() / 2), Limit::corner);
  EXPECT_EQ(run.shares().count(Limit::curve), 0U);
}

TEST(LimitedBy, WithoutToleranceNoCornerIsRounded) {
  Drive run;
  run.line({40, 0, 0}, 100).line({40, 40, 0}, 100, 0).stop();
  EXPECT_EQ(run.shares().count(Limit::corner), 0U);
}

// Acceleration takes 100 / 500 + 0.025 s, and its distance takes half of this time at full speed. So half is lost, at both ends.
TEST(LostTime, OfALineBothItsRamps) {
  Drive run;
  run.line({200, 0, 0}, 100).stop();
  const auto worst = run.lost.worst(10);
  ASSERT_EQ(worst.size(), 1U);
  EXPECT_NEAR(worst[0].at_feed, 2, 1e-9);
  EXPECT_NEAR(worst[0].lost(), 0.225, 1e-9);
  EXPECT_EQ(worst[0].by.limit, Limit::acceleration);
  EXPECT_NEAR(run.time.cutting.all, 2.225, 1e-9);
  EXPECT_NEAR(run.time.cutting.speeding_up, 0.225, 1e-9);
  EXPECT_NEAR(run.time.cutting.slowing_down, 0.225, 1e-9);
}

TEST(LostTime, TheWorstLinesFirstAndThoseThatComeAgainAsOne) {
  Drive run;
  double x = 0;
  for (int pass = 0; pass < 3; ++pass)
    for (std::uint32_t line = 1; line <= 4; ++line) {
      run.tag = Spent{Spent::On::cutting, line}.tag();
      run.line({x += 100, 0, 0}, 30.0 * line).stop();
    }
  const auto worst = run.lost.worst(3);
  ASSERT_EQ(worst.size(), 3U);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(worst[i].line, 4 - i);
    EXPECT_EQ(worst[i].times, 3U);
  }
  EXPECT_NEAR(worst[0].lost(), 3 * (120.0 / 500 + 0.025), 1e-9);
}

TEST(LostTime, AFullTableKeepsTheWorst) {
  LostTime lost(limits, 16);
  const auto cells_of = [](std::uint32_t line, double seconds) {
    TimedCells cells{3, {TimeLaw::of_jerk(seconds, 1, 0, 0)}, {{Spent{Spent::On::cutting, line}.tag(), 10, Bend::none}}, {}};
    cells.path.assign(3 * TimedCells::terms, 0);
    cells.path[1] = 1;
    return cells;
  };
  for (std::uint32_t line = 1; line <= 10'000; ++line) lost.take(cells_of(line, line % 1000 == 0 ? 1 + line * 1e-4 : 1e-3));
  const auto worst = lost.worst(8);
  ASSERT_EQ(worst.size(), 8U);  // at least half of the table
  for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(worst[i].line, 10'000 - 1000 * i);
}

TEST(LostTime, PausesAndMotionsWithoutATimeLoseNothing) {
  LostTime lost(limits);
  for (const double feed : {0.0, unlimited_feed}) {
    TimedCells cells{3, {TimeLaw{5, 0, true, 0, 0, 0}}, {{Spent{Spent::On::dwell, 1}.tag(), feed, Bend::none}}, {}};
    cells.path.assign(3 * TimedCells::terms, 0);
    lost.take(cells);
  }
  EXPECT_TRUE(lost.worst(10).empty());
}

}  // namespace
}  // namespace kadr::limited_by_test
