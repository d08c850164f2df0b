// panel/panel_machine with several channels: each channel has its own
// axes and its own clock, and they wait for each other at waiting codes.

#include <algorithm>
#include <cmath>

#include "panel/a_panel.h"
#include "panel/panel_machine.h"

namespace kadr::panel_channels_test {
namespace {

using test::APanel;

/// Channel 1 has X, Y and Z; channel 2 has an X and a Z of its own.
APanel two_channels(const std::string& first, const std::string& second, PanelRecorder keeper = {}) {
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

/// The first channel arrives at once and waits until the second has arrived; neither passes a waiting code before the other arrives.
TEST(PanelChannels, WaitForEachOther) {
  const APanel panel = two_channels(first, second);
  ASSERT_TRUE(panel->run());
  // A channel is reported as waiting when its program waits, a moment before its axes stop.
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.channels[0].waits && std::fabs(axis(s, 0, 0) - 10) < 1e-9; }));
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

/// The positions are those of the servo clock: X of the first channel leaves 10 only when Z of the second is at 50.
TEST(PanelChannels, LeaveAWaitingCodeTogether) {
  const APanel panel =
      two_channels("G21 G90 G94\nG0 X10\nM501 P12\nG1 X20 F3000\nM30\n", "G21 G90 G94\nG1 Z50 F6000\nM501 P12\nG1 X50 F6000\nM30\n");
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

/// A stop of one channel holds all channels; they continue together.
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

/// This also works before the program begins.
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

PanelSearch::Answer found(const APanel& panel, const PanelSearch::SearchRequest& request) {
  PanelSearch::Answer answer;
  EXPECT_TRUE(panel.until([&](const PanelState&) { return (answer = panel->find(request)).ready; }));
  EXPECT_TRUE(answer.place) << answer.error;
  return answer;
}

/// Returns the paths of the sheets; the own channel is first.
std::vector<PanelPath> paths_to(const APanel& panel, const std::shared_ptr<const RestartPoint>& place) {
  const auto sheets = panel->sheets(place, {.clearance = 30, .above = 2, .feed = 6000});
  EXPECT_TRUE(sheets) << sheets.error();
  std::vector<PanelPath> paths;
  for (std::size_t i = 0; sheets && i < sheets->size(); ++i)
    paths.push_back({i == 0 ? panel->own() : place->other_channels[i - 1].channel, (*sheets)[i].path});
  return paths;
}

void go_to(const APanel& panel, const PanelSearch::SearchRequest& request, const std::set<std::string>& left = {}) {
  const auto place = found(panel, request).place;
  ASSERT_TRUE(place);
  const auto went = panel->go_there(place, left, paths_to(panel, place));
  ASSERT_TRUE(went) << went.error();
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && !s.goes_there; }));
  ASSERT_EQ(panel->state().why, "restart") << panel->state().message;
}

/// The restart is in mid program, where the other channel moves too: each channel is led to where the program would have had it.
TEST(PanelChannels, GoOnInMidProgramTogether) {
  const APanel panel = two_channels(first, second);
  const auto place = found(panel, {.target = {.line = 4}}).place;
  ASSERT_TRUE(place);
  ASSERT_EQ(place->other_channels.size(), 1u);
  const OtherChannelState& other = place->other_channels.front();
  EXPECT_EQ(other.number, 2);
  EXPECT_EQ(other.line.number, 4u) << "both have met at M501";
  EXPECT_NEAR(other.restart.stand.machine[1], 50, 1e-9);
  EXPECT_FALSE(other.waits);
  go_to(panel, {.target = {.line = 4}});
  const PanelState there = panel->state();
  EXPECT_EQ(there.line.number, 4u);
  EXPECT_NEAR(axis(there, 0, 0), 10, 1e-9);
  EXPECT_NEAR(axis(there, 1, 1), 50, 1e-9);
  EXPECT_EQ(there.channels[1].line.number, 4u);
  bool in_order = true, was_there = false;
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([&](const PanelState& s) {
    was_there = was_there || axis(s, 0, 0) >= 20 - 1e-6 || (s.channels[0].waits && s.channels[0].waits->code == 502);
    in_order = in_order && (was_there || axis(s, 1, 1) >= 40 - 1e-6);
    return s.mode == PanelMode::ended;
  }));
  EXPECT_TRUE(in_order) << "neither goes beyond M502 before the other";
  EXPECT_NEAR(axis(panel->state(), 0, 0), 0, 1e-9);
  EXPECT_NEAR(axis(panel->state(), 1, 0), 5, 1e-9);
  EXPECT_NEAR(axis(panel->state(), 1, 1), 0, 1e-9);
}

/// The other channel waits at a waiting code that the own channel has not reached yet; it waits until the own channel arrives.
TEST(PanelChannels, GoOnWhileTheOtherWaits) {
  const char* const own = "G21 G90 G94\nG1 X10 F6000\nG4 P1\nX20\nM501 P12\nX30\nM30\n";
  const char* const other = "G21 G90 G94\nG1 Z5 F6000\nM501 P12\nZ0\nM30\n";
  const APanel panel = two_channels(own, other);
  const auto place = found(panel, {.target = {.line = 4}}).place;
  ASSERT_TRUE(place && place->other_channels.front().waits);
  EXPECT_EQ(place->other_channels.front().waits->code, 501u);
  EXPECT_EQ(place->other_channels.front().line.number, 3u);
  go_to(panel, {.target = {.line = 4}});
  EXPECT_NEAR(axis(panel->state(), 1, 1), 5, 1e-9);
  bool waited = false, in_order = true;
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([&](const PanelState& s) {
    waited = waited || (s.channels[1].waits && s.channels[1].waits->code == 501 && s.channels[1].waits->here == std::set<int>{2});
    in_order = in_order && (axis(s, 0, 0) >= 20 - 1e-6 || std::fabs(axis(s, 1, 1) - 5) < 1e-9);
    return s.mode == PanelMode::ended || s.mode == PanelMode::alarm;
  }));
  EXPECT_TRUE(waited);
  EXPECT_TRUE(in_order);
  EXPECT_EQ(panel->state().mode, PanelMode::ended);
  EXPECT_NEAR(axis(panel->state(), 0, 0), 30, 1e-9);
  EXPECT_NEAR(axis(panel->state(), 1, 1), 0, 1e-9);
}

/// The program of the other channel has ended: nothing of it is executed again.
TEST(PanelChannels, GoOnAfterTheOtherHasEnded) {
  const APanel panel = two_channels("G21 G90 G94\nG1 X10 F6000\nG4 P1\nX20\nM30\n", "G21 G90 G94\nG1 Z5 F6000\nM30\n");
  go_to(panel, {.target = {.line = 4}});
  EXPECT_NEAR(axis(panel->state(), 1, 1), 5, 1e-9);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(axis(panel->state(), 0, 0), 20, 1e-9);
  EXPECT_NEAR(axis(panel->state(), 1, 1), 5, 1e-9);
}

/// The other program loops without end; the search still comes to its end.
TEST(PanelChannels, AnotherWithoutAnEndIsNoHindrance) {
  const APanel panel = two_channels("G21 G90 G94\nG1 X10 F6000\nX20\nM30\n", "G21 G90 G94\nG1 Z5 F6000\nZ0\nM99\n");
  go_to(panel, {.target = {.line = 3}});
  PanelSearch::Answer nowhere;
  ASSERT_TRUE(panel.until([&](const PanelState&) { return (nowhere = panel->find({.target = {.line = 99}})).ready; }));
  EXPECT_FALSE(nowhere.place);
  EXPECT_FALSE(nowhere.error.empty());
}

/// The tool and the spindle of each channel are brought by lines in that channel, or left as they are.
TEST(PanelChannels, EachHasASheetOfItsOwn) {
  const APanel panel =
      two_channels("G21 G90 G94\nT3 M6\nG1 X10 F6000\nG4 P1\nX20\nM30\n", "G21 G90 G94\nT7 M6\nF500\nG1 Z5\nG4 P5\nZ0\nM30\n");
  const auto place = found(panel, {.target = {.line = 5}}).place;
  ASSERT_TRUE(place);
  const auto sheets = panel->sheets(place, {});
  ASSERT_TRUE(sheets) << sheets.error();
  ASSERT_EQ(sheets->size(), 2u);
  const auto tool = [](const PanelSheet& sheet) {
    for (const PanelSheet::Row& row : sheet.rows)
      if (row.required && row.required->kind == InForce::Kind::tool) return row;
    return PanelSheet::Row{};
  };
  ASSERT_TRUE(tool((*sheets)[0]).required && tool((*sheets)[1]).required);
  EXPECT_EQ(tool((*sheets)[0]).required->value, 3);
  EXPECT_EQ(tool((*sheets)[1]).required->value, 7);
  EXPECT_EQ(tool((*sheets)[1]).by, PanelSheet::By::line);
  std::vector<std::pair<std::string, double>> changes;  // of the machine, in their order
  std::mutex lock;
  panel->watch([&](const Step& step) {
    const std::lock_guard hold(lock);
    if (const auto* const change = std::get_if<ToolChange>(&step.action.what)) changes.emplace_back("tool", double(change->tool));
  });
  go_to(panel, {.target = {.line = 5}});
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].second, 3);
  EXPECT_EQ(changes[1].second, 7);
  const auto in_force = panel->state().channels[1].block.modes->in_force;
  EXPECT_TRUE(
      std::any_of(in_force.begin(), in_force.end(), [](const InForce& one) { return one.kind == InForce::Kind::tool && one.value == 7; }));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_EQ(changes.size(), 2u);
  EXPECT_NEAR(axis(panel->state(), 1, 1), 0, 1e-9);
}

TEST(PanelChannels, WaysMustEndWhereEachChannelBegins) {
  const APanel panel = two_channels(first, second);
  const auto place = found(panel, {.target = {.line = 4}}).place;
  ASSERT_TRUE(place);
  auto paths = paths_to(panel, place);
  EXPECT_FALSE(panel->go_there(place, {}, {paths[0]})) << "the other does not stand there";
  EXPECT_FALSE(panel->go_there(place, {}, {paths[0], paths[0]}));
  std::swap(paths[0], paths[1]);  // the other channel is led first
  bool other_first = true;
  ASSERT_TRUE(panel->go_there(place, {}, paths));
  ASSERT_TRUE(panel.until([&](const PanelState& s) {
    other_first = other_first && (axis(s, 0, 0) <= 1e-9 || std::fabs(axis(s, 1, 1) - 50) < 1e-3);
    return s.mode == PanelMode::standing && !s.goes_there;
  }));
  EXPECT_EQ(panel->state().why, "restart");
  EXPECT_TRUE(other_first);
}

/// The other channel is in the middle of a block, so it cannot be led away from there.
TEST(PanelChannels, NothingIsLedAwayFromAWaitingCode) {
  const APanel panel = two_channels("G21 G90 G94\nG4 P1\nM0\nM501 P12\nM30\n", "G21 G90 G94\nM501 P12\nG0 Z1\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.why == "M0"; }));
  const auto place = found(panel, {.target = {.line = 2}}).place;
  ASSERT_TRUE(place);
  EXPECT_FALSE(panel->sheets(place, {}));
  ASSERT_TRUE(panel->reset());
  EXPECT_TRUE(panel.until([&](const PanelState&) { return panel->sheets(place, {}).has_value(); }));
}

/// The tables are edited in mid program: all axes keep their positions, and the following motions use the new tables.
TEST(PanelChannels, TablesAreTakenOverInMidProgram) {
  const APanel panel = two_channels("G21 G90 G94 G54\nG0 X10\nM0\nM501 P12\nG0 X20\nM30\n", "G21 G90 G94\nG0 Z50\nM501 P12\nG0 Z60\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.why == "M0"; }));
  panel.edit([](kadr::Setup& tables) { tables.work_offsets["G54"]["X"] = 100; });
  const auto taken = panel->take_tables();
  ASSERT_TRUE(taken) << taken.error();
  ASSERT_TRUE(panel.until([](const PanelState& s) { return !s.takes_tables; }));
  EXPECT_TRUE(panel->state().message.empty()) << panel->state().message;
  EXPECT_NEAR(axis(panel->state(), 0, 0), 10, 1e-9);
  EXPECT_NEAR(axis(panel->state(), 1, 1), 50, 1e-9);
  EXPECT_NEAR(panel->state().block.work_of(panel->state().sample.machine)[0], -90, 1e-9);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(axis(panel->state(), 0, 0), 120, 1e-9);
  EXPECT_NEAR(axis(panel->state(), 1, 1), 60, 1e-9);
}

/// M0 of the other channel holds in the middle of a block of the own channel: the tables stay as they are, and nothing starts again.
TEST(PanelChannels, TablesAreNotTakenOverWhereTheOtherHolds) {
  const APanel panel = two_channels("G21 G90 G94\nG0 X3\nM501 P12\nG0 X20\nM30\n", "G21 G90 G94\nG0 Z50\nM0\nG0 Z60\nM501 P12\nM30\n");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.why == "M0"; }));
  EXPECT_FALSE(panel->may_apply_tables());
  EXPECT_FALSE(panel->take_tables());
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  EXPECT_NEAR(axis(panel->state(), 1, 1), 60, 1e-9);
}

/// The keeper stores the positions of all axes, and the axes are restored there.
TEST(PanelChannels, StandWhereTheyWereKept) {
  std::mutex lock;
  PanelLocation last;
  PanelRecorder keeper;
  keeper.spot = [&](const PanelLocation& spot) {
    const std::lock_guard hold(lock);
    last = spot;
    return std::string();
  };
  const APanel panel = two_channels(first, second, keeper);
  ASSERT_TRUE(panel->jog("Z", 3, 0, 2));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && axis(s, 1, 1) > 2.9; }));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  const std::lock_guard hold(lock);
  ASSERT_EQ(last.stands.size(), 2u);
  EXPECT_NEAR(last.stands[1][0], 5, 1e-9);
}

/// A channel with a long program does not fill the memory while the other waits for motion.
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
}  // namespace kadr::panel_channels_test
