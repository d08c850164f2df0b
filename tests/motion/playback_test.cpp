// The servo clock: positions from planned cells under feed hold and override. The
// output obeys every limit, stays on the path, and ends at the end of the path.

#include "motion/play/playback.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <thread>

namespace kadr::playback_test {
namespace {

constexpr double speed = 200, acceleration = 1000, jerk = 20000, rate = 1000;
constexpr std::size_t axes = 3;
using Point = std::array<double, axes>;

MotionLimits limits() {
  return {std::vector<double>(axes, speed), std::vector<double>(axes, acceleration), std::vector<double>(axes, jerk)};
}

struct Piece {
  Point to;
  double feed, tolerance;
};

/// Returns the whole plan as one set of cells.
TimedCells planned(const std::vector<Piece>& pieces) {
  TimedCells all;
  all.axes = axes;
  Planner planner(limits(), [&](const TimedCells& cells) {
    all.laws.insert(all.laws.end(), cells.laws.begin(), cells.laws.end());
    all.sources.insert(all.sources.end(), cells.sources.begin(), cells.sources.end());
    all.path.insert(all.path.end(), cells.path.begin(), cells.path.end());
  });
  const Point start{};
  planner.begin(start.data());
  std::uint64_t tag = 0;
  for (const Piece& piece : pieces) planner.line_to(piece.to.data(), piece.feed, piece.tolerance, false, tag++);
  planner.stop();
  return all;
}

/// An override that is in force from one instant on.
struct Change {
  std::size_t instant;
  double share;
};

struct Played {
  std::vector<Point> points;
  double speed = 0, acceleration = 0, jerk = 0;  // greatest of any axis, from differences of the samples
  std::uint64_t starved = 0;
};

void measure(Played& run) {
  const auto& p = run.points;
  for (std::size_t i = 3; i < p.size(); ++i)
    for (std::size_t a = 0; a < axes; ++a) {
      run.speed = std::max(run.speed, std::fabs(p[i][a] - p[i - 1][a]) * rate);
      run.acceleration = std::max(run.acceleration, std::fabs(p[i][a] - 2 * p[i - 1][a] + p[i - 2][a]) * rate * rate);
      run.jerk = std::max(run.jerk, std::fabs(p[i][a] - 3 * p[i - 1][a] + 3 * p[i - 2][a] - p[i - 3][a]) * rate * rate * rate);
    }
}

constexpr std::size_t too_many = 2'000'000;  // instants; the run does not reach its end

Played played(const TimedCells& cells, const std::vector<Change>& changes, std::size_t at_a_time = 1, std::size_t ring = 1 << 16) {
  Playback playback(limits(), rate, ring);
  Played run;
  std::size_t offered = 0, next = 0;
  std::array<Point, 16> rows;
  while (!playback.done() && run.points.size() < too_many) {
    offered += playback.offer(cells, offered);
    if (offered == cells.laws.size()) playback.finish();
    for (; next < changes.size() && changes[next].instant <= run.points.size(); ++next) playback.override_to(changes[next].share);
    const std::size_t count = playback.fill(rows[0].data(), at_a_time);
    run.points.insert(run.points.end(), rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count));
  }
  run.starved = playback.starved();
  measure(run);
  return run;
}

/// Returns the deviation from the nearest point of the plan, sampled every 0.1 ms.
double off_plan(const Played& run, const TimedCells& plan) {
  std::vector<Point> places;
  for (std::size_t k = 0; k < plan.laws.size(); ++k) {
    const int count = 1 + static_cast<int>(plan.laws[k].seconds * 1e4);
    for (int i = 0; i <= count; ++i)
      plan.position(k, plan.laws[k].distance(plan.laws[k].seconds * i / count), places.emplace_back().data());
  }
  double worst = 0;
  std::size_t near = 0;  // searches forward along the path, never back
  for (const Point& p : run.points) {
    const auto away = [&](std::size_t i) { return std::hypot(p[0] - places[i][0], p[1] - places[i][1], p[2] - places[i][2]); };
    constexpr std::size_t ahead = 40;
    std::size_t best = near;
    for (std::size_t i = near; i < std::min(near + ahead, places.size()); ++i)
      if (away(i) < away(best)) best = i;
    near = best;
    worst = std::max(worst, away(best));
  }
  return worst;
}

const std::vector<Piece> corner{{{40, 0, 0}, 100, 0.01}, {{40, 25, 0}, 100, 0.01}};

TEST(Playback, WithoutOverrideItGivesThePlanAtEachInstant) {
  const TimedCells plan = planned(corner);
  const Played run = played(plan, {});
  double begins = 0;
  std::size_t instant = 0;
  const auto now = [&] { return static_cast<double>(instant) / rate; };
  for (std::size_t k = 0; k < plan.laws.size(); begins += plan.laws[k++].seconds)
    for (; now() < begins + plan.laws[k].seconds; ++instant) {
      Point at;
      plan.position(k, plan.laws[k].distance(now() - begins), at.data());
      for (std::size_t a = 0; a < axes; ++a) ASSERT_NEAR(run.points[instant][a], at[a], 1e-9) << instant;
    }
  EXPECT_EQ(run.points.size(), instant + 1);
  EXPECT_NEAR(run.points.back()[0], 40, 1e-12);
  EXPECT_NEAR(run.points.back()[1], 25, 1e-12);
}

TEST(Playback, RowsAtATimeMakeNoDifference) {
  const TimedCells plan = planned(corner);
  const std::vector<Change> changes{{0, 0.5}};
  EXPECT_EQ(played(plan, changes, 1).points, played(plan, changes, 16).points);
}

TEST(Playback, HalfTheOverrideTakesTwiceAsLong) {
  const TimedCells plan = planned(corner);
  EXPECT_NEAR(static_cast<double>(played(plan, {{0, 0.5}}).points.size()), 2 * static_cast<double>(played(plan, {}).points.size()), 3);
}

// From 100 mm/s, with 1000 mm/s² and 20,000 mm/s³, it cannot stop before 0.15 s; a smooth ramp needs slightly more.
TEST(Playback, AFeedHoldStopsAndAResumeGoesOn) {
  const TimedCells plan = planned({{{100, 0, 0}, 100, 0}});
  const Played run = played(plan, {{500, 0}, {2000, 1}});
  EXPECT_GT(run.points[600][0] - run.points[599][0], 1e-3);
  EXPECT_EQ(run.points[800], run.points[1999]);
  EXPECT_NEAR(run.points.back()[0], 100, 1e-12);
  EXPECT_LE(run.acceleration, acceleration * 1.001);
  EXPECT_LE(run.jerk, jerk * 1.001);
  EXPECT_NEAR(static_cast<double>(run.points.size()), 1150 + 1500 + 110, 110);
}

/// Returns a star. Its speed is never constant: everywhere along the plan one axis uses all of its jerk.
std::vector<Piece> star() {
  std::vector<Piece> pieces;
  Point at{};
  constexpr int corners = 24;
  constexpr double turn = 2.4;  // radians, more than a right angle
  for (int i = 0; i < corners; ++i) {
    at[0] += 2 * std::cos(turn * i), at[1] += 2 * std::sin(turn * i);
    pieces.push_back({at, 100, 0.02});
  }
  return pieces;
}

// A single ramp for the whole change would have to be so slow that it takes up to 1.5 s.
TEST(Playback, AFeedHoldStandsSoonWhereThePlanUsesAllOfTheJerk) {
  constexpr std::size_t soon = 700;  // instants
  const TimedCells plan = planned(star());
  const std::size_t instants = played(plan, {}).points.size();
  for (std::size_t at = 40; at + soon < instants; at += 29) {
    const std::size_t resume = at + soon;
    const Played run = played(plan, {{at, 0}, {resume, 1}});
    EXPECT_EQ(run.points[resume - 1], run.points[resume - 2]) << at;
    EXPECT_LE(run.acceleration, acceleration * 1.001) << at;
    EXPECT_LE(run.jerk, jerk * 1.007) << at;
  }
}

TEST(Playback, AnOverrideDoesNotLengthenAPauseAFeedHoldDoes) {
  const TimedCells pause{axes, {TimeLaw{0.5, 0, true, 0, 0, 0}}, {{7, 0, Bend::none}}, std::vector<double>(axes * TimedCells::terms, 0.0)};
  EXPECT_EQ(played(pause, {{0, 0.25}}).points.size(), 501U);
  EXPECT_NEAR(static_cast<double>(played(pause, {{100, 0}, {300, 1}}).points.size()), 701, 12);
}

// At the end of a cell the jerk of the plan jumps, here from +19,700 to −10,000 mm/s³ shortly after an instant. A ramp that is checked
// at the instants only has 24,300 mm/s³ there.
TEST(Playback, ARampKeepsTheJerkWhereThePlansOwnJumps) {
  const TimedCells plan = planned({{{0.037301733035709911, -0.0072512559279498297, 0}, 35, 0.01},
                                   {{0.11112567225939744, -0.035376440327297157, 0}, 41, 0.1},
                                   {{0.12898463838856999, -0.046424396192391276, 0.3}, 36, 0.1},
                                   {{0.18797657848151295, -0.095911273281884701, 0.6}, 5, 0.01},
                                   {{0.20942938542861966, -0.12228885986766183, 0.9}, 9, 0.01},
                                   {{0.25293900071420661, -0.19992849779636562, 0.9}, 23, 0.01}});
  EXPECT_LE(played(plan, {{3, 0.8}}).jerk, jerk * 1.01);
}

// So few cells are known that a whole ramp does not fit into them: the speed changes in small steps.
TEST(Playback, ATinyRingSlowsButNeverStops) {
  const TimedCells plan = planned(corner);
  const Played run = played(plan, {{50, 0}, {300, 1}}, 1, 24);
  EXPECT_LT(run.points.size(), too_many);
  EXPECT_EQ(run.starved, 0U);
  EXPECT_NEAR(run.points.back()[1], 25, 1e-12);
  EXPECT_LE(run.acceleration, acceleration * 1.001);
  EXPECT_LE(run.jerk, jerk * 1.005);  // the jerk of the plan itself, between the sampled positions
}

TEST(Playback, WhereNoSwitchActsNothingChanges) {
  TimedCells plan = planned(corner);
  const Played as_planned = played(plan, {});
  for (CellSource& source : plan.sources) source.switches = {false, false};
  EXPECT_EQ(played(plan, {{0, 0.3}, {100, 0}, {300, 0.5}}).points, as_planned.points);
}

TEST(Playback, AFeedHoldActsWhereTheOverrideDoesNot) {
  TimedCells plan = planned(corner);
  const std::size_t instants = played(plan, {}).points.size();
  for (CellSource& source : plan.sources) source.switches = {false, true};
  EXPECT_EQ(played(plan, {{0, 0.3}}).points.size(), instants);
  EXPECT_GT(played(plan, {{0, 0.3}, {100, 0}, {900, 0.3}}).points.size(), instants + 700);
}

TEST(Playback, TheOverrideActsWhereAFeedHoldDoesNot) {
  TimedCells plan = planned(corner);
  for (CellSource& source : plan.sources) source.switches = {true, false};
  EXPECT_EQ(played(plan, {{0, 0.3}, {100, 0}}).points, played(plan, {{0, 0.3}}).points);
}

// 10 mm, a wait for the spindle, then 20 mm synchronous with it: 37 degrees per
// mm, at a constant rate. A delay during the first 10 mm is made up by the wait.
TEST(Playback, TheAxesWaitForTheSpindlesAngle) {
  constexpr double rate_of_spindle = -1850, waits = 0.02;  // degrees/s, s
  TimedCells plan;
  plan.axes = 1;
  const auto add = [&](const TimeLaw& law, double from, double angle, bool awaited, bool acts) {
    plan.laws.push_back(law);
    plan.sources.push_back({0, 0, Bend::none, 0, {acts, acts}});
    plan.path.insert(plan.path.end(), {from, 1, 0, 0, 0, 0});
    plan.spindle.push_back({angle, rate_of_spindle, 0, awaited, false});
  };
  const double distance = jerk * 0.1 * 0.1 * 0.1 / 6, fast = jerk * 0.1 * 0.1 / 2;  // distance and speed of a ramp of 0.1 s
  add(TimeLaw::of_jerk(0.1, 0, 0, jerk / 2), 0, 0, false, true);
  add(TimeLaw::of_jerk(0.1, fast / 2, jerk * 0.05, -jerk / 2), distance / 2, rate_of_spindle * 0.1, false, true);
  add(TimeLaw::of_jerk(waits, 0, 0, 0), 10, rate_of_spindle * 0.2, true, false);
  add(TimeLaw::of_jerk(0.2, 50, 0, 0), 10, rate_of_spindle * (0.2 + waits), false, false);
  for (const double share : {1.0, 0.9, 0.41, 0.05}) {
    Playback playback(MotionLimits{{speed}, {acceleration}, {jerk}}, rate);
    playback.offer(plan, 0);
    playback.finish();
    playback.override_to(share);
    double x = 0;
    int in_step = 0;
    for (double last = 0; !playback.done();) {
      ASSERT_EQ(playback.fill(&x, 1), 1U);
      if (last != 0 && !playback.done()) {
        EXPECT_NEAR(playback.spindle() - last, rate_of_spindle / rate, 1e-9);
      }
      last = playback.spindle();
      if (!(x > 10) || playback.done()) continue;
      const double planned = rate_of_spindle * (0.2 + waits) - 37 * (x - 10);
      EXPECT_NEAR(std::remainder(playback.spindle() - planned, 360), 0, 1e-9) << share << " at " << x;
      ++in_step;
    }
    EXPECT_GT(in_step, 198);
  }
}

TEST(Playback, NothingPlannedEndsAtOnce) {
  Playback playback(limits(), rate);
  Point row;
  EXPECT_EQ(playback.fill(row.data(), 1), 0U);
  EXPECT_FALSE(playback.done());
  playback.finish();
  EXPECT_EQ(playback.fill(row.data(), 1), 0U);
  EXPECT_TRUE(playback.done());
}

std::vector<Piece> random_pieces() {
  std::vector<Piece> pieces;
  Point at{};
  const bool tiny = *rc::gen::arbitrary<bool>();
  const int count = *rc::gen::inRange(2, 40);
  double heading = 0;
  for (int i = 0; i < count; ++i) {
    const double step = tiny ? *rc::gen::inRange(10, 500) * 1e-3 : *rc::gen::inRange(1, 400) * 0.1;
    heading += tiny ? *rc::gen::inRange(-100, 101) * 2e-3 : *rc::gen::inRange(0, 361) * 3.14159265358979323846 / 180;
    at = {at[0] + step * std::cos(heading), at[1] + step * std::sin(heading), at[2] + (*rc::gen::inRange(0, 5) == 0 ? 0.3 : 0.0)};
    pieces.push_back({at, *rc::gen::inRange(5, 200) * 1.0, *rc::gen::element(0.0, 0.01, 0.1)});
  }
  return pieces;
}

std::vector<Change> random_changes() {
  std::vector<Change> changes;
  std::size_t at = 0;
  for (int left = *rc::gen::inRange(1, 12); left-- > 0;) {
    at += static_cast<std::size_t>(*rc::gen::inRange(1, 900));
    changes.push_back({at, *rc::gen::element(0.0, 0.1, 0.5, 0.8, 1.0)});
  }
  changes.push_back({at + 300, 1});
  return changes;
}

void obeys(const Played& run, const TimedCells& plan, const Point& end) {
  const Played planned_run = played(plan, {});
  RC_ASSERT(run.points.size() < too_many);
  RC_ASSERT(run.starved == 0U);
  RC_ASSERT(run.speed <= speed * 1.002);
  RC_ASSERT(run.acceleration <= std::max(acceleration, planned_run.acceleration) * 1.002);
  RC_ASSERT(run.jerk <= jerk * 1.02);       // the jerk of the plan itself, which is checked at sampled positions only: docs/planner.md
  RC_ASSERT(off_plan(run, plan) <= 0.011);  // half of the distance travelled in 0.1 ms at 200 mm/s
  for (std::size_t a = 0; a < axes; ++a) RC_ASSERT(std::fabs(run.points.back()[a] - end[a]) < 1e-9);
}

RC_GTEST_PROP(PlaybackProperty, UnderOverridesItObeysEveryLimitAndStaysOnThePath, ()) {
  const std::vector<Piece> pieces = random_pieces();
  const TimedCells plan = planned(pieces);
  obeys(played(plan, random_changes()), plan, pieces.back().to);
}

// The planner is slower than the clock, or the ring buffer is small.
RC_GTEST_PROP(PlaybackProperty, ItBrakesWhenCellsComeTooLate, ()) {
  const std::vector<Piece> pieces = random_pieces();
  const TimedCells plan = planned(pieces);
  Playback playback(limits(), rate, 1 << 16);
  Played run;
  std::size_t offered = 0;
  double sent = 0;
  const double pace = *rc::gen::element(0.3, 0.8);  // seconds of plan that arrive per second
  while (!playback.done() && run.points.size() < too_many) {
    TimedCells some{axes, {}, {}, {}};
    const double due = 1.5 + pace * static_cast<double>(run.points.size()) / rate;
    for (; offered < plan.laws.size() && sent < due; ++offered) {
      sent += plan.laws[offered].seconds;
      some.laws.push_back(plan.laws[offered]);
      some.sources.emplace_back();
      const auto from = plan.path.begin() + static_cast<std::ptrdiff_t>(offered * axes * TimedCells::terms);
      some.path.insert(some.path.end(), from, from + axes * TimedCells::terms);
    }
    RC_ASSERT(playback.offer(some, 0) == some.laws.size());
    if (offered == plan.laws.size()) playback.finish();
    Point row;
    if (playback.fill(row.data(), 1) == 1) run.points.push_back(row);
  }
  run.starved = playback.starved();
  measure(run);
  obeys(run, plan, pieces.back().to);
}

TEST(Playback, PlannerAndClockInTwoThreads) {
  const TimedCells plan = planned(corner);
  Playback playback(limits(), rate, 64);
  std::thread planner([&] {
    for (std::size_t offered = 0; offered < plan.laws.size(); std::this_thread::yield()) offered += playback.offer(plan, offered);
    playback.finish();
  });
  std::vector<Point> points;
  Point row;
  while (!playback.done())
    if (playback.fill(row.data(), 1) == 1) points.push_back(row);
    else std::this_thread::yield();
  planner.join();
  EXPECT_NEAR(points.back()[1], 25, 1e-12);
}

}  // namespace
}  // namespace kadr::playback_test
