// panel/panel_machine with several channels: each has its axes and its clock; at waiting codes they wait for each other.

#include "panel/a_panel.h"
#include "panel/panel_machine.h"

namespace kadr {
namespace {

using test::APanel;

/// Channel 1 has X, Y, Z, channel 2 an X and a Z of its own.
APanel two_channels(const std::string& first, const std::string& second, PanelKeeper keeper = {}) {
  kadr::Setup setup;
  setup.channels[2] = {second, {"X", "Z"}};
  setup.parameters[ParameterKey{"2201", "", ""}] = 501.;  // the waiting codes
  setup.parameters[ParameterKey{"2202", "", ""}] = 510.;
  return APanel(first, "nct", setup, std::move(keeper));
}

const char* const first = "G21 G90 G94\nG0 X10\nM501 P12\nG0 X20\nM502 P12\nG0 X0\nM30\n";
const char* const second = "G21 G90 G94\nG1 Z50 F6000\nM501 P12\nG0 X5\nG1 Z40 F6000\nM502 P12\nG0 Z0\nM30\n";

double axis(const PanelState& s, std::size_t channel, std::size_t a) { return s.channels[channel].sample.machine[a]; }

TEST(PanelChannels, StandSideBySideBeforeTheyBegin) {
  const APanel panel = two_channels(first, second);
  const PanelState s = panel->state();
  EXPECT_EQ(s.mode, PanelMode::standing);
  ASSERT_EQ(s.channels.size(), 2u);
  EXPECT_EQ(s.channels[0].axes, (std::vector<std::string>{"X", "Y", "Z"}));
  EXPECT_EQ(s.channels[1].axes, (std::vector<std::string>{"X", "Z"}));
  EXPECT_EQ(s.channels[1].number, 2);
}

/// The first is there at once and stands until the second has come; neither goes beyond a waiting code before the other.
TEST(PanelChannels, WaitForEachOther) {
  const APanel panel = two_channels(first, second);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.channels[0].waits.has_value(); }));
  const PanelState waits = panel->state();
  EXPECT_EQ(waits.mode, PanelMode::running);
  EXPECT_EQ(waits.line.number, 3u);
  EXPECT_EQ(waits.channels[0].line.number, 3u);
  EXPECT_EQ(waits.channels[0].waits->code, 501u);
  EXPECT_EQ(waits.channels[0].waits->channels, (std::set<int>{1, 2}));
  EXPECT_FALSE(waits.channels[0].waits->here.contains(2));
  EXPECT_NEAR(axis(waits, 0, 0), 10, 1e-9);
  EXPECT_LT(axis(waits, 1, 1), 50);
  bool in_order = true, has_waited_again = false;
  ASSERT_TRUE(panel.until([&](const PanelState& s) {
    in_order = in_order && (axis(s, 0, 0) <= 10 + 1e-9 || axis(s, 1, 0) > -1e-9);
    has_waited_again = has_waited_again || (s.channels[0].waits && s.channels[0].waits->code == 502);
    return s.mode == PanelMode::ended;
  }));
  EXPECT_TRUE(has_waited_again);
  const PanelState s = panel->state();
  EXPECT_NEAR(axis(s, 0, 0), 0, 1e-9);
  EXPECT_NEAR(axis(s, 1, 0), 5, 1e-9);
  EXPECT_NEAR(axis(s, 1, 1), 0, 1e-9);
}

/// Positions are those of the servo clock: the first one's X leaves 10 only when the second's Z is at 50.
TEST(PanelChannels, LeaveAWaitingCodeTogether) {
  const APanel panel = two_channels("G21 G90 G94\nG0 X10\nM501 P12\nG1 X20 F3000\nM30\n", "G21 G90 G94\nG1 Z50 F6000\nM501 P12\nG1 X50 F6000\nM30\n");
  ASSERT_TRUE(panel->run());
  std::size_t seen = 0;
  ASSERT_TRUE(panel.until([&](const PanelState& s) {
    if (axis(s, 1, 1) < 50 - 1e-6) {
      EXPECT_LE(axis(s, 0, 0), 10 + 1e-9);
      ++seen;
    }
    return s.mode == PanelMode::ended;
  }));
  EXPECT_GT(seen, 10u);
}

TEST(PanelChannels, AFeedHoldHoldsAll) {
  const APanel panel = two_channels("G21 G90 G94\nG1 X100 F3000\nM30\n", "G21 G90 G94\nG1 Z100 F3000\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return axis(s, 0, 0) > 1 && axis(s, 1, 1) > 1; }));
  ASSERT_TRUE(panel->hold());
  ASSERT_TRUE(panel.stands(PanelMode::held));
  const PanelState held = panel->state();
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(axis(panel->state(), 0, 0), axis(held, 0, 0));
  EXPECT_EQ(axis(panel->state(), 1, 1), axis(held, 1, 1));
  EXPECT_LT(axis(held, 0, 0), 99);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(axis(panel->state(), 1, 1), 100, 1e-9);
}

TEST(PanelChannels, AnEmergencyStopStopsAllAndAResetLeavesThemWhereTheyStand) {
  const APanel panel = two_channels("G21 G90 G94\nG1 X100 F3000\nM30\n", "G21 G90 G94\nG1 Z100 F3000\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return axis(s, 0, 0) > 1 && axis(s, 1, 1) > 1; }));
  panel->stop_at_once();
  ASSERT_TRUE(panel.stands(PanelMode::emergency));
  const PanelState stopped = panel->state();
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  EXPECT_EQ(axis(panel->state(), 0, 0), axis(stopped, 0, 0));
  EXPECT_EQ(axis(panel->state(), 1, 1), axis(stopped, 1, 1));
  EXPECT_GT(axis(stopped, 1, 1), 1);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(axis(panel->state(), 1, 1), 100, 1e-9);
}

TEST(PanelChannels, AResetWhileTheyRunBrakesAll) {
  const APanel panel = two_channels("G21 G90 G94\nG1 X100 F3000\nM30\n", "G21 G90 G94\nG1 Z100 F3000\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return axis(s, 0, 0) > 1 && axis(s, 1, 1) > 1; }));
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  EXPECT_GT(axis(panel->state(), 1, 1), 1);
  EXPECT_LT(axis(panel->state(), 1, 1), 99);
}

/// A stop of one channel holds all of them; they go on together.
TEST(PanelChannels, AStopOfTheOtherChannelHolds) {
  const APanel panel = two_channels("G21 G90 G94\nM501 P12\nG0 X20\nM30\n", "G21 G90 G94\nG0 Z50\nM0\nG0 Z60\nM501 P12\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  EXPECT_EQ(panel->state().why, "M0");
  EXPECT_NEAR(axis(panel->state(), 1, 1), 50, 1e-9);
  EXPECT_NEAR(axis(panel->state(), 0, 0), 0, 1e-9);
  EXPECT_FALSE(panel->enter("G0 X7")) << "its channel waits";
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(axis(panel->state(), 1, 1), 60, 1e-9);
  EXPECT_NEAR(axis(panel->state(), 0, 0), 20, 1e-9);
}

TEST(PanelChannels, SingleBlocksOfTheOwnChannelComeToTheEnd) {
  const APanel panel = two_channels(first, second);
  ASSERT_TRUE(panel->set_single(true));
  int presses = 0;
  while (panel->state().mode != PanelMode::ended && presses < 20) {
    ASSERT_TRUE(panel->run());
    ++presses;
    ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing || s.mode == PanelMode::ended; }));
  }
  EXPECT_EQ(presses, 7);
  EXPECT_NEAR(axis(panel->state(), 1, 0), 5, 1e-9);
}

/// Before the program begins too.
TEST(PanelChannels, ALineByHandMovesItsChannelAlone) {
  const APanel panel = two_channels(first, second);
  ASSERT_TRUE(panel->enter("G0 X7"));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && axis(s, 0, 0) > 6.9; }));
  EXPECT_EQ(axis(panel->state(), 1, 1), 0);
  ASSERT_TRUE(panel->enter("M501 P12")) << "an alarm of it: nobody comes";
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.alarm.has_value(); }));
  EXPECT_EQ(panel->state().alarm->alarm.id, AlarmId::channels_wait);
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing || s.mode == PanelMode::alarm; }));
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(axis(panel->state(), 1, 0), 5, 1e-9);
}

TEST(PanelChannels, AxesOfEachAreMovedByHand) {
  const APanel panel = two_channels(first, second);
  ASSERT_TRUE(panel->jog("X", 3, 0, 2));
  ASSERT_TRUE(panel.stands(PanelMode::standing));
  EXPECT_NEAR(axis(panel->state(), 1, 0), 3, 1e-9);
  EXPECT_EQ(axis(panel->state(), 0, 0), 0);
  EXPECT_FALSE(panel->jog("Y", 3, 0, 2)) << "it has none";
  EXPECT_FALSE(panel->jog("X", 3, 0, 3)) << "there is none";
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(axis(panel->state(), 1, 0), 5, 1e-9);
}

TEST(PanelChannels, WhoWaitsInVainIsAnAlarm) {
  const APanel panel = two_channels("G21 G90 G94\nG0 X10\nM501 P12\nM30\n", "G21 G90 G94\nG0 Z10\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::alarm));
  EXPECT_EQ(panel->state().alarm->alarm.id, AlarmId::channels_wait);
  EXPECT_NEAR(axis(panel->state(), 1, 1), 10, 1e-9);
}

TEST(PanelChannels, CannotGoOnInMidProgram) {
  const APanel panel = two_channels(first, second);
  PanelSearch::Wish wish;
  wish.target.line = 4;
  const PanelSearch::Answer found = panel->find(wish);
  EXPECT_TRUE(found.ready);
  EXPECT_FALSE(found.error.empty());
}

/// One that has much to do does not fill the memory while the other is short of motion.
TEST(PanelChannels, ALongProgramBesideAShortOneIsNotPlannedToItsEnd) {
  std::string lines = "G21 G90 G94\nG1 F60\n";
  for (int i = 0; i < 20000; ++i) lines += i % 2 == 0 ? "X10\n" : "X0\n";
  const APanel panel = two_channels(lines + "M30\n", "G21 G90 G94\nG4 P1\nG1 Z1 F60\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return axis(s, 1, 1) > 0.5 && axis(s, 0, 0) > 0.5; }));
  EXPECT_LT(panel->state().blocks, 1000u);
  panel->stop_at_once();
}

}  // namespace
}  // namespace kadr
