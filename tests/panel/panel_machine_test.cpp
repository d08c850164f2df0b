// panel/panel_machine: what an operator does with a machine, in real time.

#include "panel/panel_machine.h"

#include <atomic>
#include <thread>

#include "panel/a_panel.h"

namespace kadr::panel_machine_test {
namespace {

using namespace std::chrono_literals;
using test::APanel;
using test::expect_at;

PanelOverrides feed_share(double share) {
  PanelOverrides shares;
  shares.feed = share;
  return shares;
}

const char* const square = "G21 G90 G94 G17\nG0 X10 Y0 Z5\nG1 Z0 F6000\nX50\nG3 X60 Y10 I0 J10 F900\nG1 Y40 F6000\nG0 Z20\nM30\n";

TEST(PanelMachine, RunsToTheEndInItsOwnTime) {
  const APanel panel(square);
  EXPECT_EQ(panel->state().mode, PanelMode::standing);
  EXPECT_EQ(panel.line(), 1u);
  ASSERT_TRUE(panel->run());
  EXPECT_TRUE(panel.until([](const PanelState& s) { return s.sample.plays && s.block.origin.line == 5 && s.sample.speed > 100; }));
  EXPECT_FALSE(panel->run() && panel->enter("G0 X0")) << "an entered line while it runs";
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {60, 40, 20});
  EXPECT_EQ(panel->state().sample.speed, 0);
}

/// The first motion must not wait until hundreds of long motions are planned.
TEST(PanelMachine, BeginsBeforeMuchIsPlanned) {
  std::string program = "G21 G90 G94\nG1 F3000\n";
  for (int i = 0; i < 2000; ++i) program += i % 2 == 0 ? "X100 Y7\n" : "X0 Y0\n";
  const APanel panel(program + "M30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[0] > 0.01; }));
  EXPECT_LT(panel->state().blocks, 100u);
  panel->stop_at_once();
}

TEST(PanelMachine, RunsAgainFromWhereItStands) {
  const APanel panel("G21 G91\nG0 X10\nM30\n");
  for (int i = 1; i <= 3; ++i) {
    ASSERT_TRUE(panel->run());
    ASSERT_TRUE(panel.until([&](const PanelState& s) { return s.mode == PanelMode::ended && s.sample.machine[0] > 10 * i - 1e-9; }));
    expect_at(panel, {10. * i, 0, 0});
  }
}

/// A busy control refuses a request after two seconds, and does not execute the refused request later.
TEST(PanelMachine, WhatIsRefusedNeverHappens) {
  std::atomic<bool> is_busy{false};
  PanelRecorder keeper;
  keeper.tables = [&](const kadr::Setup&, const kadr::Setup&) {
    if (!is_busy.exchange(true)) std::this_thread::sleep_for(5s);
    return std::string();
  };
  const APanel panel("G21 G90\nG0 X1\nM30\n", "mach3", {}, keeper);
  ASSERT_TRUE(panel->enter("G10 L1 P3 R1"));
  ASSERT_TRUE(panel.until([&](const PanelState&) { return is_busy.load(); }));
  EXPECT_FALSE(panel->set_single(true));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.can_undo == 1; }));
  EXPECT_FALSE(panel->state().single);
  EXPECT_TRUE(panel->set_single(true));
}

TEST(PanelMachine, GoesBlockByBlock) {
  const APanel panel(square);
  ASSERT_TRUE(panel->set_single(true));
  const double z[] = {0, 5, 0, 0};
  for (std::uint32_t line = 1; line <= 4; ++line) {
    EXPECT_EQ(panel.line(), line);
    ASSERT_TRUE(panel->run());
    ASSERT_TRUE(panel.until([&](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == line + 1; }));
    EXPECT_NEAR(panel.at().z, z[line - 1], 1e-9);
  }
  expect_at(panel, {50, 0, 0});
  ASSERT_TRUE(panel->set_single(false));
  ASSERT_TRUE(panel->run());
  EXPECT_TRUE(panel.stands(PanelMode::ended));
}

TEST(PanelMachine, HoldsAndGoesOn) {
  const APanel panel("G21 G91 G94\nG1 X200 F3000\nG1 Y10\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[0] > 2; }));
  ASSERT_TRUE(panel->hold());
  ASSERT_TRUE(panel.stands(PanelMode::held));
  const Vec3 there = panel.at();
  EXPECT_LT(there.x, 200);
  EXPECT_EQ(there.y, 0);
  std::this_thread::sleep_for(20ms);
  expect_at(panel, {there.x, 0, 0});
  EXPECT_FALSE(panel->enter("G0 X0"));
  ASSERT_TRUE(panel->set_overrides(feed_share(0.5)));
  EXPECT_EQ(panel->state().mode, PanelMode::held) << "an override is no run";
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {200, 10, 0});
}

TEST(PanelMachine, AnOverrideOfZeroStandsAndGoesOnByItself) {
  const APanel panel("G21 G91 G94\nG1 X60 F3000\nM30\n");
  ASSERT_TRUE(panel->set_overrides(feed_share(0)));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::held));
  EXPECT_LT(panel.at().x, 60);
  ASSERT_TRUE(panel->set_overrides(feed_share(1)));
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {60, 0, 0});
  for (const double share : {-0.1, 2.1, double(NAN)}) EXPECT_FALSE(panel->set_overrides(feed_share(share)));
}

TEST(PanelMachine, AResetBrakesOnThePathAndIsAtTheBeginning) {
  const APanel panel("G21 G90 G94\nG1 X200 F3000\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[0] > 2; }));
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 1; }));
  const Vec3 there = panel.at();
  EXPECT_GT(there.x, 2);
  EXPECT_LT(there.x, 200);
  EXPECT_EQ(there.y, 0);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {200, 0, 0});
}

TEST(PanelMachine, AnEmergencyStopStandsUntilTheReset) {
  const APanel panel("G21 G90 G94\nG1 X200 F3000\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[0] > 2; }));
  panel->stop_at_once();
  const std::uint64_t instant = panel->state().sample.instant;
  ASSERT_TRUE(panel.stands(PanelMode::emergency));
  EXPECT_LE(panel->state().sample.instant, instant + 2) << "an instant of the clock or two";
  EXPECT_FALSE(panel->run());
  EXPECT_FALSE(panel->enter("G0 X0"));
  EXPECT_FALSE(panel->jog("X", 1, 0));
  const Vec3 there = panel.at();
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  expect_at(panel, {there.x, 0, 0});
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {200, 0, 0});
  panel->stop_at_once();
  ASSERT_TRUE(panel.stands(PanelMode::emergency)) << "while it stands, too";
}

TEST(PanelMachine, M0HoldsAndM1IfItIsAskedFor) {
  const char* const program = "G21 G91\nG0 X10\nM0\nG0 X10\nM1\nG0 X10\nM30\n";
  const APanel panel(program);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 4; }));
  expect_at(panel, {10, 0, 0});
  EXPECT_EQ(panel->state().why, "M0");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {30, 0, 0});

  const APanel stopping(program);
  ASSERT_TRUE(stopping->set_optional_stop(true));
  ASSERT_TRUE(stopping->run());
  ASSERT_TRUE(stopping.stands(PanelMode::standing));
  ASSERT_TRUE(stopping->run());
  ASSERT_TRUE(stopping.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 6; }));
  expect_at(stopping, {20, 0, 0});
}

TEST(PanelMachine, StopsAtALineAndByACondition) {
  const APanel panel("G21 G91\n#1=0\nM98 P7 L8\nM30\nO7\n#1=[#1+1]\nG0 X10\nM99\n");
  const auto condition = panel->add_stop({0, {}, 0, {}, "#1 > 4"});
  ASSERT_TRUE(condition);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.hit != 0; }));
  expect_at(panel, {40, 0, 0});
  EXPECT_EQ(panel->state().hit, *condition);
  ASSERT_TRUE(panel->remove_stop(*condition));
  EXPECT_FALSE(panel->remove_stop(*condition));
  const auto line = panel->add_stop({4, {}, 0, {}, {}});
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 4; }));
  expect_at(panel, {80, 0, 0});
  EXPECT_TRUE(line);
  EXPECT_FALSE(panel->add_stop({0, {}, 0, {}, "#1 >"}));
}

TEST(PanelMachine, LinesThatAreEnteredAreUndone) {
  const APanel panel("G21 G90\nG0 X10\nM30\n");
  ASSERT_TRUE(panel->enter("#5=7 G0 Y20"));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[1] > 19.9999; }));
  ASSERT_TRUE(panel->enter("G91 G0 Z#5"));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[2] > 6.9999; }));
  expect_at(panel, {0, 20, 7});
  EXPECT_EQ(panel->state().can_undo, 2u);
  ASSERT_TRUE(panel->undo());
  expect_at(panel, {0, 20, 0});
  ASSERT_TRUE(panel->undo());
  expect_at(panel, {0, 0, 0});
  EXPECT_FALSE(panel->undo());
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {10, 0, 0});  // G91 was undone
  ASSERT_TRUE(panel->enter("G0 X1"));
  ASSERT_TRUE(panel.stands(PanelMode::ended)) << "after the program's end";
}

TEST(PanelMachine, AFaultyLineIsToldAndNothingMoves) {
  const APanel panel("G21 G90\nG0 X10\nM30\n");
  ASSERT_TRUE(panel->enter("G0 X5 X6"));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.alarm; }));
  expect_at(panel, {0, 0, 0});
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_FALSE(panel->state().alarm);
  for (const std::string& bad : {std::string(), std::string("G0 X1\nG0 X2"), std::string(2000, 'X')}) EXPECT_FALSE(panel->enter(bad));
}

TEST(PanelMachine, AnAlarmOfTheProgramStandsUntilTheReset) {
  const APanel panel("G21 G90\nG0 X10\nG1 X20 X30\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::alarm));
  expect_at(panel, {10, 0, 0});
  ASSERT_TRUE(panel->state().alarm);
  EXPECT_EQ(panel->state().alarm->origin.line, 3u);
  EXPECT_FALSE(panel->run());
  ASSERT_TRUE(panel->reset());
  EXPECT_EQ(panel->state().mode, PanelMode::standing);
}

TEST(PanelMachine, AxesGoByHandAndTheControlKnows) {
  kadr::Setup setup;
  setup.work_offsets["G54"] = {{"X", 100}, {"Y", 0}, {"Z", 0}};
  const APanel panel("G21 G91\nG0 X10\nM30\n", "mach3", setup);
  ASSERT_TRUE(panel->jog("X", 25, 6000));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[0] > 24.9999; }));
  ASSERT_TRUE(panel->jog("Z", -3, 0));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[2] < -2.9999; }));
  expect_at(panel, {25, 0, -3});
  ASSERT_TRUE(panel->enter("G90 G0 Y1"));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[1] > 0.9999; }));
  expect_at(panel, {25, 1, -3});  // the line starts from the current positions
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {35, 1, -3});
  EXPECT_FALSE(panel->jog("X", 1000, 0)) << "beyond the end of its way";
  EXPECT_FALSE(panel->jog("Q", 1, 0));
  EXPECT_FALSE(panel->jog("X", NAN, 0));
}

TEST(PanelMachine, AProgramWithoutAnEndRunsAndIsReset) {
  const APanel panel("G90 G21\no100 while [1]\n#1=[#1+1]\no100 endwhile\nM2\n", "linuxcnc");
  ASSERT_TRUE(panel->run());  // not refused with "it has begun and is not over yet"
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(panel->state().mode, PanelMode::running);
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  EXPECT_EQ(panel.line(), 1u);
}

}  // namespace
}  // namespace kadr::panel_machine_test
