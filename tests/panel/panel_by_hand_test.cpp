// Axes that a held key moves, overrides above 100 %, and requests that take long.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "a_panel.h"

using namespace kadr;
using namespace kadr::test;
using namespace std::chrono_literals;

namespace {

const std::string short_program = "G21 G90\nG0 X1\nM30\n";
using Clock = std::chrono::steady_clock;

/// Waits until the axes have their speed.
bool moves(const APanel& panel) {
  return panel.until([](const PanelState& s) { return s.sample.plays && s.sample.speed > 5'900; });
}

}  // namespace

TEST(PanelByHand, AnAxisMovesAsLongAsTheKeyIsHeld) {
  const APanel panel(short_program);
  ASSERT_TRUE(panel->jog_while_held("X", 1, 6'000));
  for (int i = 0; i < 10; ++i) {
    std::this_thread::sleep_for(100ms);
    EXPECT_TRUE(panel->keep_jogging(true)) << i;
  }
  EXPECT_EQ(panel->state().mode, PanelMode::running) << "longer than the machine stays without a renewal";
  ASSERT_TRUE(panel->keep_jogging(false));
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  EXPECT_GT(panel.at().x, 50);
  EXPECT_LT(panel.at().x, 500);
  EXPECT_FALSE(panel->keep_jogging(true)) << "the key is no longer held";
  EXPECT_EQ(panel.line(), 1U) << "before the same block as before";
}

TEST(PanelByHand, AnAxisStopsByItselfIfNothingIsHeardOfTheKey) {
  const APanel panel(short_program);
  ASSERT_TRUE(panel->jog_while_held("X", -1, 6'000));
  const auto begin = Clock::now();
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  EXPECT_GE(seconds, 0.25);
  EXPECT_LT(panel.at().x, -10);
  EXPECT_GT(panel.at().x, -100 * seconds - 1) << "no further than the time allows";
}

/// 20 ms is the figure that docs/benchmarks.md promises; the least of five tries, because the test machine may be busy.
TEST(PanelByHand, TheAxisBeginsToSlowDownSoonAfterTheRelease) {
  double least = 1;
  for (int i = 0; i < 5; ++i) {
    const APanel panel(short_program);
    ASSERT_TRUE(panel->jog_while_held("X", 1, 6'000));
    ASSERT_TRUE(moves(panel));
    const double speed = panel->state().sample.speed;
    const auto begin = Clock::now();
    ASSERT_TRUE(panel->keep_jogging(false));
    while (panel->state().sample.speed > 0.999 * speed) std::this_thread::sleep_for(100us);
    least = std::min(least, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  RecordProperty("seconds", std::to_string(least));
  EXPECT_LE(least, 0.02);
}

TEST(PanelByHand, AHeldKeyStopsAtTheEndOfTheTravel) {
  const APanel panel(short_program);
  ASSERT_TRUE(panel->jog("X", 495, 0));
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  ASSERT_TRUE(panel->jog_while_held("X", 1, 0));
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  EXPECT_NEAR(panel.at().x, 500, 1e-6);
  EXPECT_FALSE(panel->jog_while_held("X", 1, 0)) << "there is no way left";
  EXPECT_FALSE(panel->jog_while_held("Q", 1, 0));
  EXPECT_FALSE(panel->jog_while_held("X", 0, 0));
  EXPECT_FALSE(panel->jog_while_held("X", std::nan(""), 0));
}

TEST(PanelByHand, AHeldKeyObeysFeedHoldAndEmergencyStop) {
  const APanel panel(short_program);
  ASSERT_TRUE(panel->jog_while_held("X", 1, 6'000));
  ASSERT_TRUE(moves(panel));
  ASSERT_TRUE(panel->hold());
  ASSERT_TRUE(panel.stands(PanelMode::standing)) << "the key is not heard of: the motion is over";
  ASSERT_TRUE(panel->jog_while_held("X", 1, 6'000));
  ASSERT_TRUE(moves(panel));
  panel->stop_at_once();
  ASSERT_TRUE(panel.stands(PanelMode::emergency));
  EXPECT_FALSE(panel->keep_jogging(true));
  EXPECT_FALSE(panel->jog_while_held("X", 1, 6'000)) << "in emergency";
}

TEST(PanelByHand, AProgramThatRunsIsNotDisturbedByAKey) {
  const APanel panel("G21 G90\nG1 F6000 X100\nM30\n");
  ASSERT_TRUE(panel->run());
  EXPECT_FALSE(panel->jog_while_held("Y", 1, 1'000));
  EXPECT_FALSE(panel->keep_jogging(false)) << "the program goes on";
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(panel.at().x, 100, 1e-6);
}

TEST(PanelByHand, AFeedOverrideAbove100PercentIsFaster) {
  const APanel panel("G21 G90\nG1 F1200 X10\nX20\nM30\n");
  PanelOverrides shares;
  shares.feed = 1.5;
  ASSERT_TRUE(panel->set_overrides(shares));
  ASSERT_TRUE(panel->run());
  double fastest = 0;
  while (panel->state().mode != PanelMode::ended) {
    fastest = std::max(fastest, panel->state().sample.speed);
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_NEAR(fastest, 1'800, 1) << "150 % of 1200 mm/min";
  shares.feed = 2.01;
  EXPECT_FALSE(panel->set_overrides(shares));
  shares.feed = 1, shares.rapid = 1.01;
  EXPECT_FALSE(panel->set_overrides(shares)) << "rapid motion is not faster than the machine";
}

TEST(PanelByHand, AnOverrideBackTo100PercentActsAtOnce) {
  const APanel panel("G21 G90\nG1 F1200 X100\nM30\n");
  PanelOverrides shares;
  shares.feed = 2;
  ASSERT_TRUE(panel->set_overrides(shares));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.speed > 2'399; }));
  shares.feed = 1;
  ASSERT_TRUE(panel->set_overrides(shares));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return std::fabs(s.sample.speed - 1'200) < 1; }));
}

TEST(PanelByHand, AThreadKeepsItsFeedAt200Percent) {
  const APanel panel("G21 G90 G97 S600 M3\nG33 Z-20 K1\nM30\n", "linuxcnc");
  PanelOverrides shares;
  shares.feed = 2;
  ASSERT_TRUE(panel->set_overrides(shares));
  ASSERT_TRUE(panel->run());
  double fastest = 0;
  while (panel->state().mode != PanelMode::ended && panel->state().mode != PanelMode::alarm) {
    fastest = std::max(fastest, panel->state().sample.speed);
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(panel->state().mode, PanelMode::ended);
  EXPECT_NEAR(fastest, 600, 5) << "1 mm per revolution at 600 rev/min";
}

TEST(PanelByHand, AStopTellsItsLine) {
  const APanel panel("G21 G90\nM0 (TURN THE PART)\nG0 X1\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.why == "M0" && s.mode == PanelMode::standing; }));
  EXPECT_EQ(panel->state().stop.number, 2U);
  EXPECT_EQ(panel->state().stop.text, "M0 (TURN THE PART)");
}

/// Reading the program takes long: the reset has begun, so it is neither refused nor done.
TEST(PanelByHand, ARequestThatTakesLongIsQueuedAndThenDone) {
  std::atomic<bool> is_slow{false};
  PanelRecorder keeper;
  keeper.begins = [&] {
    if (is_slow) std::this_thread::sleep_for(6s);
  };
  const APanel panel(short_program, "mach3", {}, keeper);
  const auto quick = panel->set_single(true);
  ASSERT_TRUE(quick);
  EXPECT_EQ(*quick, PanelMachine::Outcome::done);
  ASSERT_TRUE(panel->jog("X", 5, 0));
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 2; }));
  is_slow = true;
  const auto reset = panel->reset();
  ASSERT_TRUE(reset) << reset.error();
  EXPECT_EQ(*reset, PanelMachine::Outcome::queued);
  EXPECT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 1; }));
}
