// panel/panel_machine, panel_keeping: edited tables, variables, watches, switches, questions of the program, and what is kept.

#include <cmath>

#include "panel/a_panel.h"

namespace kadr::panel_tables_test {
namespace {

using test::APanel;
using test::expect_at;

bool stands_at(const APanel& panel, std::uint32_t line) {
  return panel.until([=](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == line && !s.takes_tables; });
}

TEST(PanelTables, AZeroIsTakenOverAtTheBeginning) {
  const APanel panel("G21 G90 G54\nG0 X10\nM30\n", "nct");
  panel.edit([](kadr::Setup& tables) { tables.work_offsets["G54"]["X"] = 100; });
  ASSERT_TRUE(panel->take_tables());
  ASSERT_TRUE(stands_at(panel, 1));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {110, 0, 0});
}

/// In mid program the axes keep their positions; the next motions use the new tables, in the same pass of a call.
TEST(PanelTables, AnOffsetIsTakenOverInMidProgram) {
  const APanel panel("G21 G90 G54\n#1=0\nM98 P7 L3\nM30\nO7\n#1=#1+1\nG0 X#1\nM0\nG0 Y#1\nM99\n", "nct");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(stands_at(panel, 9));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[0] == 2; }));
  panel.edit([](kadr::Setup& tables) { tables.work_offsets["G54"]["X"] = 50; });
  panel.edit([](kadr::Setup& tables) { tables.work_offsets["G54"]["Y"] = -20; });
  ASSERT_TRUE(panel->take_tables());
  ASSERT_TRUE(stands_at(panel, 9));
  expect_at(panel, {2, 1, 0});
  EXPECT_NEAR(panel->state().block.work_of(panel->state().sample.machine)[0], 2 - 50, 1e-9);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[0] == 53; }));
  expect_at(panel, {53, -18, 0});
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {53, -17, 0});
}

TEST(PanelTables, TablesThatLeadElsewhereAreTold) {
  kadr::Setup setup;
  setup.variables["#100"] = 1;
  const APanel panel("G21 G90\nIF[#100EQ1] GOTO 5\nG0 X1\nM30\nN5 G0 Y1\nM0\nG0 Y2\nM30\n", "nct", setup);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(stands_at(panel, 7));
  panel.edit([](kadr::Setup& tables) { tables.variables["#100"] = 2; });
  ASSERT_TRUE(panel->take_tables());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return !s.takes_tables; }));
  EXPECT_FALSE(panel->state().message.empty());
  expect_at(panel, {0, 1, 0});
}

/// Under cutter compensation the programmed point differs from the position of the axes and would be lost.
TEST(PanelTables, NotInACompensatedContour) {
  kadr::Setup setup;
  setup.offsets[1].radius = 3;
  const APanel panel("G21 G90 G94 G17\nG0 X-20 Y-20\nG42 D1 G1 X0 Y0 F6000\nX20\nY20\nX0\nG40 X-20 Y-20\nM0\nG0 X1\nM30\n", "mach3", setup);
  ASSERT_TRUE(panel->add_stop({.line = 5}));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(stands_at(panel, 5));
  EXPECT_FALSE(panel->may_apply_tables());
  EXPECT_FALSE(panel->take_tables());
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(stands_at(panel, 9));
  EXPECT_TRUE(panel->may_apply_tables());
  panel.edit([](kadr::Setup& tables) { tables.offsets[1].radius = 4; });
  ASSERT_TRUE(panel->take_tables());
  ASSERT_TRUE(stands_at(panel, 9));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {1, -20, 0});
}

/// G10 entered by hand: the confirmed value stays whenever the program is read again.
TEST(PanelTables, ALineByHandIsAsAnEdit) {
  for (const char* const control : {"nct", "mach3", "linuxcnc", "grbl"}) {
    const APanel panel("G21 G90 G54\nG0 X10\nM0\nG0 X20\nM30\n", control);
    ASSERT_TRUE(panel->run()) << control;
    ASSERT_TRUE(stands_at(panel, 4)) << control;
    ASSERT_TRUE(panel->enter("G10 L2 P1 Y30"));
    ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.can_undo == 1; }));
    panel.edit([](kadr::Setup& tables) { tables.work_offsets["G54"]["X"] = 5; });
    ASSERT_TRUE(panel->take_tables()) << control;
    ASSERT_TRUE(stands_at(panel, 4)) << control;
    const Axes at = panel->state().sample.machine;
    EXPECT_NEAR(panel->state().block.work_of(at)[1], -30, 1e-9) << control << ": an edit";
    EXPECT_NEAR(panel->state().block.work_of(at)[0], 5, 1e-9) << control;
    ASSERT_TRUE(panel->reset());
    ASSERT_TRUE(stands_at(panel, 1)) << control;
    EXPECT_NEAR(panel->state().block.work_of(panel->state().sample.machine)[1], -30, 1e-9) << control << ": a reset";
    PanelSearch::Answer found;
    ASSERT_TRUE(panel.until([&](const PanelState&) { return (found = panel->find({{.line = 4}, 0, false, {}})).ready; }));
    ASSERT_TRUE(found.place) << found.error;
    EXPECT_NEAR(found.place->placement.origin[1], 30, 1e-9) << control << ": a restart";
  }
}

TEST(PanelTables, ALineThatIsTakenBackIsNoEdit) {
  const APanel panel("G21 G90 G54\nG0 X10\nM30\n", "mach3");
  ASSERT_TRUE(panel->enter("G10 L2 P1 Y30"));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.can_undo == 1; }));
  ASSERT_TRUE(panel->undo());
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(stands_at(panel, 1));
  EXPECT_NEAR(panel->state().block.work_of(panel->state().sample.machine)[1], 0, 1e-9);
}

/// If a line entered by hand changes tool data, the data before and after the change are both reported.
TEST(PanelTables, WhatALineByHandChangesIsTold) {
  std::mutex lock;
  std::vector<std::pair<kadr::Setup, kadr::Setup>> changes;
  PanelRecorder keeper;
  keeper.tables = [&](const kadr::Setup& before, const kadr::Setup& after) {
    const std::lock_guard hold(lock);
    changes.emplace_back(before, after);
    return std::string("the disk is full");
  };
  kadr::Setup setup;
  setup.offsets[2].radius = 3, setup.offsets[2].length = 50;
  const APanel panel("G21 G90\nG10 L1 P3 R1\nG0 X1\nM0\nM30\n", "mach3", setup, keeper);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(stands_at(panel, 5));
  EXPECT_TRUE(changes.empty()) << "what the program writes is the program's";
  const auto enter = [&](const char* line, std::size_t count) {
    ASSERT_TRUE(panel->enter(line));
    ASSERT_TRUE(panel.until([=](const PanelState& s) { return s.mode == PanelMode::standing && s.can_undo == count; }));
  };
  enter("G10 L1 P2 R4", 1);
  EXPECT_EQ(panel->state().message, "the disk is full");
  enter("G0 X2", 2);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].first.offsets.at(2).radius, 3);
  EXPECT_EQ(changes[0].second.offsets.at(2).radius, 4);
  EXPECT_EQ(changes[0].second.offsets.at(2).length, 50);
}

TEST(PanelTables, NotWhileItRuns) {
  const APanel panel("G21 G91\nG1 X200 F600\nM30\n");
  ASSERT_TRUE(panel->run());
  EXPECT_FALSE(panel->may_apply_tables());
  EXPECT_FALSE(panel->take_tables());
  panel->stop_at_once();
}

TEST(PanelTables, VariablesTellTheLineThatSetThem) {
  kadr::Setup setup;
  setup.variables["#500"] = 3;
  const APanel panel("G21 G90\n#100=5\nG0 X1\n#101=#100+1\n#100=6\nM0\nM30\n", "nct", setup);
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(stands_at(panel, 7));
  ASSERT_TRUE(panel->enter("#102=9"));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.can_undo == 1; }));
  const auto tables = panel->tables();
  ASSERT_TRUE(tables);
  std::map<std::string, std::pair<double, std::uint32_t>> found;
  for (const PanelVariable& one : tables->variables) found[one.name] = {one.value, one.line};
  EXPECT_EQ(found["#100"], std::pair(6.0, 5u));
  EXPECT_EQ(found["#101"], std::pair(6.0, 4u));
  EXPECT_EQ(found["#102"], std::pair(9.0, 0u));
  EXPECT_EQ(found["#500"], std::pair(3.0, 0u));
  const auto values = panel->watch_values({"#100*2", "#100+", "#777"});
  ASSERT_TRUE(values);
  EXPECT_EQ((*values)[0].value, 12);
  EXPECT_FALSE((*values)[1].value);
  EXPECT_FALSE((*values)[2].value);
}

TEST(PanelQuestions, AProgramWaitsForItsAnswer) {
  const APanel panel("G21 G90\n#3107=200(GO ON? YES NO)\n#100=#3107\nIF[#100EQ3] GOTO 9\nG0 X10\nM30\nN9 G0 Y10\nM30\n", "nct");
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.asks; })) << panel->state().message;
  EXPECT_FALSE(panel->state().message.empty());
  EXPECT_FALSE(panel->run()) << "it waits for an answer";
  EXPECT_FALSE(panel->answer(4));
  ASSERT_TRUE(panel->answer(3));
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {0, 10, 0});
  EXPECT_FALSE(panel->answer(1)) << "nothing is asked";
}

TEST(PanelSwitches, RapidAndDryRunAndSpindle) {
  const APanel panel("G21 G90 G94 M3 S1000\nG0 X30\nG1 X50 F10\nM30\n");
  PanelOverrides shares;
  shares.rapid = 0.05, shares.dry_feed = 6000;
  ASSERT_TRUE(panel->set_overrides(shares));
  ASSERT_TRUE(panel->run());
  double fastest = 0;
  ASSERT_TRUE(panel.until([&](const PanelState& s) {
    if (s.block.origin.line == 2 && s.sample.machine[0] > 5) fastest = std::max(fastest, s.sample.speed);
    return s.mode == PanelMode::ended;  // at F10 it would take two minutes; until() waits one minute
  }));
  EXPECT_GT(fastest, 100);
  EXPECT_LT(fastest, 0.06 * 60'000);
  for (PanelOverrides bad : {PanelOverrides{2.1, 1, 1, 0}, PanelOverrides{1, -1, 1, 0}, PanelOverrides{1, 1, 0.4, 0},
                             PanelOverrides{1, 1, 1.3, 0}, PanelOverrides{1, 1, 1, -1}})
    EXPECT_FALSE(panel->set_overrides(bad));
}

TEST(PanelSwitches, StopsWhenAToolComes) {
  const APanel panel("G21 G90\nT1 M6\nG0 X1\nT2 M6\nG0 X2\nT1 M6\nG0 X3\nM30\n");
  StopPoint point;
  point.tool = 1;
  ASSERT_TRUE(panel->add_stop(point));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(stands_at(panel, 3));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(stands_at(panel, 7));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
}

TEST(PanelSwitches, StepsOverAndOutOfCalls) {
  const APanel panel("G21 G90\nM98 P7\nG0 X2\nM30\nO7\nG0 X1\nG0 Y1\nM99\n");
  ASSERT_TRUE(panel->run(Stepping::How::block));
  ASSERT_TRUE(stands_at(panel, 2));
  ASSERT_TRUE(panel->run(Stepping::How::over));
  ASSERT_TRUE(stands_at(panel, 3));
  expect_at(panel, {1, 1, 0});
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(stands_at(panel, 1));
  for (const std::uint32_t line : {2u, 6u}) {
    ASSERT_TRUE(panel->run(Stepping::How::block));
    ASSERT_TRUE(
        panel.until([=](const PanelState& s) { return s.mode == PanelMode::standing && (s.line.number == line || s.line.number == 5); }));
  }
  ASSERT_TRUE(panel->run(Stepping::How::out));
  ASSERT_TRUE(stands_at(panel, 3));
}

TEST(PanelKeeping, EachBlockAndEachEvent) {
  std::mutex lock;
  std::vector<PanelLocation> spots;
  std::vector<std::string> events;
  PanelRecorder keeper;
  keeper.spot = [&](const PanelLocation& spot) {
    const std::lock_guard hold(lock);
    spots.push_back(spot);
    return std::string(spot.number == 3 ? "the disk is full" : "");
  };
  keeper.event = [&](const char* kind, const std::string& text, std::uint32_t line) {
    const std::lock_guard hold(lock);
    events.push_back(std::string(kind) + " " + text + " " + std::to_string(line));
  };
  {
    const APanel panel("G21 G91 G94\nG1 X20 F1500\nG1 X20\nM0\nG1 X20\nM30\n", "mach3", {}, keeper);
    ASSERT_TRUE(panel->enter("G0 Z1"));  // a line by hand is not counted
    ASSERT_TRUE(panel.until([](const PanelState& s) { return s.can_undo == 1 && s.mode == PanelMode::standing; }));
    ASSERT_TRUE(panel->run());
    ASSERT_TRUE(panel.until([](const PanelState& s) { return !s.save_fault.empty(); }));
    ASSERT_TRUE(stands_at(panel, 5));
    EXPECT_TRUE(panel->state().save_fault.empty()) << "it is kept again";
    ASSERT_TRUE(panel->run());
    ASSERT_TRUE(panel.stands(PanelMode::ended));
  }
  std::vector<std::uint32_t> running;
  for (const PanelLocation& spot : spots)
    if (spot.mode == PanelMode::running && spot.number != 0 && (running.empty() || running.back() != spot.number))
      running.push_back(spot.number);
  EXPECT_EQ(running, (std::vector<std::uint32_t>{1, 2, 3, 5}));
  EXPECT_EQ(spots.back().number, 0u);
  EXPECT_EQ(spots.back().mode, PanelMode::ended);
  EXPECT_EQ(events, (std::vector<std::string>{"line G0 Z1 0", "run  1", "stopped M0 5", "run  5", "ended  0"}));
}

/// After an emergency stop or an alarm in mid program, the position of the break stays known.
TEST(PanelKeeping, WhereItWasBroken) {
  std::mutex lock;
  PanelLocation last;
  PanelRecorder keeper;
  keeper.spot = [&](const PanelLocation& spot) {
    const std::lock_guard hold(lock);
    last = spot;
    return std::string();
  };
  const auto kept = [&] {
    const std::lock_guard hold(lock);
    return last;
  };
  const APanel stopped("G21 G91 G94\nG1 X100 F1500\nM30\n", "mach3", {}, keeper);
  ASSERT_TRUE(stopped->run());
  ASSERT_TRUE(stopped.until([](const PanelState& s) { return s.sample.machine[0] > 1; }));
  stopped->stop_at_once();
  ASSERT_TRUE(stopped.stands(PanelMode::emergency));
  EXPECT_EQ(kept().mode, PanelMode::emergency);
  EXPECT_EQ(kept().number, 2u);
  EXPECT_EQ(kept().line, 2u);
  const APanel faulty("G21 G91 G94\nG1 X10 F1500\nG1 X5 X6\nM30\n", "mach3", {}, keeper);
  ASSERT_TRUE(faulty->run());
  ASSERT_TRUE(faulty.stands(PanelMode::alarm));
  EXPECT_EQ(kept().number, 2u);
}

}  // namespace
}  // namespace kadr::panel_tables_test
