// The part of a page: at its end it equals the result of `kadr cut`, at any instant the result of a cut up to that instant. Also: what
// is refused, and how a run is stopped.

#include "view/part_run.h"

#include <gtest/gtest.h>

#include <cstring>

#include "config/tools/tool_list.h"
#include "session/cutting/cut_cells.h"
#include "session/cutting/cut_run.h"
#include "session/cutting/cut_setup.h"

namespace kadr::part_run_test {
namespace {

constexpr const char* text =
    "G21 G90 G17 G54\n"
    "T1 M6\n"
    "S1000 M3\n"
    "G0 X0 Y0 Z5\n"
    "G1 Z-2 F200\n"
    "X40 F600\n"
    "G3 X40 Y20 J10\n"
    "G4 P3\n"
    "G1 X0\n"
    "G0 Z5\n"
    "T2 M6\n"
    "G0 X20 Y10\n"
    "G1 Z-8 F100\n"
    "G0 Z5\n"
    "G0 X30\n"
    "G0 Z-1\n"
    "M30\n";
constexpr const char* tools = R"([{"number": 1, "kind": "flat", "diameter": 8, "flutes": 20}, {"number": 2, "kind": "drill", "diameter": 5,
                                   "angle": 118, "flutes": 30}])";

OpenedProgram opened(const std::string& program, const std::string& setup = "") {
  OpeningRequest request;
  request.path = "part_run_test.nc";
  request.control = "mach3";
  request.text = program;
  request.setup = setup;
  auto made = open_for_page(request);
  EXPECT_TRUE(made) << made.error();
  return *made;
}

PartRequest wish_for(const std::string& stock, double resolution = 0.5) {
  PartRequest request;
  request.stock = stock;
  request.tools = *tools_of_list(tools);
  request.resolution = resolution;
  return request;
}

constexpr const char* block = "box:-10,-10,-10,60,30,0";

/// Returns what a cut of the program up to an instant leaves, computed as by `kadr cut --until`.
double left_until(const OpenedProgram& program, double until, double cell) {
  CutJob job;
  job.blank = box_blank({{-10, -10, -10}, {60, 30, 0}});
  job.tools = *tools_of_list(tools);
  job.cell = cell;
  job.until = until;
  auto session = Session::open(program.spec(*program.program(), {}));
  take_session(**session, false, job);
  CutRun run(**session, job, nullptr);
  run.attach({});
  (void)(*session)->run();
  run.finish();
  return volume_of(surface_of(run.cutting().stock()));
}

TEST(PartRun, AnyInstantIsAsIfCutUntilThen) {
  const OpenedProgram program = opened(text);
  std::vector<CutFinding> found;
  auto run = PartRun::make(program, wish_for(block), {});
  ASSERT_TRUE(run) << run.error();
  (*run)->on_finding = [&](const CutFinding& f, const AlarmReport&) { found.push_back(f); };
  ASSERT_TRUE((*run)->execute());
  const CutResult& result = (*run)->result();
  EXPECT_EQ(result.cell, 0.5);
  EXPECT_NEAR(result.left, left_until(program, 1e300, 0.5), 1e-6);
  EXPECT_NEAR((*run)->at(1e300).left, result.left, 1e-6) << "one cell is fine enough for both";
  EXPECT_NEAR((*run)->at(-5).left, result.stock, 0.01 * result.stock);
  for (int i = 0; i <= 40; ++i) {
    const double instant = result.seconds * i / 40;
    const PartThen then = (*run)->at(instant);
    EXPECT_EQ(then.seconds, instant);
    EXPECT_NEAR(then.left, left_until(program, instant, 0.5), 0.05) << instant << " s";
  }
  ASSERT_EQ(found.size(), 1U) << "the rapid into the part";
  EXPECT_EQ(found[0].origin.line, 16U);
  EXPECT_EQ(found[0].id, AlarmId::rapid_in_stock);
}

TEST(PartRun, WhatIsShownMayBeCoarser) {
  const OpenedProgram program = opened(text);
  auto run = PartRun::make(program, wish_for(block, 0.1), {});
  ASSERT_TRUE(run) << run.error();
  ASSERT_TRUE((*run)->execute());
  const PartThen then = (*run)->at(1e300);
  EXPECT_EQ((*run)->result().cell, 0.1);
  EXPECT_EQ(then.cell, 0.4);
  EXPECT_NEAR(then.left, (*run)->result().left, 0.02 * 0.4 * area_of(then.surface) + (*run)->result().error_bound);
}

TEST(PartRun, WithAccelerationsTimesAreTheMachines) {
  OpenedProgram program = opened(text);
  for (const char* axis : {"X", "Y", "Z"}) program.setup.machine[axis].acceleration = 20;
  auto run = PartRun::make(program, wish_for(block), {});
  ASSERT_TRUE(run) << run.error();
  ASSERT_TRUE((*run)->execute());
  const double whole = (*run)->result().seconds;
  const OpenedProgram programmed = opened(text);
  auto quick = PartRun::make(programmed, wish_for(block), {});
  ASSERT_TRUE(quick && (*quick)->execute());
  EXPECT_GT(whole, (*quick)->result().seconds + 2);
  for (const double share : {0.2, 0.5, 0.8}) {
    const PartThen then = (*run)->at(share * whole);
    EXPECT_NEAR(then.left, left_until(program, share * whole, 0.5), 0.05) << share;
  }
}

TEST(PartRun, TheFrameSaysWhoMadeEachPoint) {
  const OpenedProgram program = opened("G21 G90\nG92 X100 Y0 Z0\nT1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-2 F200\nX40 F600\nM30\n");
  auto run = PartRun::make(program, wish_for(block), {});
  ASSERT_TRUE(run) << run.error();
  ASSERT_TRUE((*run)->execute());
  const PartThen then = (*run)->at(1e300);
  const std::string frame = (*run)->frame_of(then);
  std::uint32_t head[4];
  std::memcpy(head, frame.data(), sizeof head);
  const std::size_t points = head[2], triangles = head[3];
  EXPECT_EQ(head[0], 3U);
  ASSERT_EQ(frame.size(), 16 + 20 * points + 12 * triangles);
  ASSERT_EQ(points, then.surface.point_count());
  std::vector<float> at(3 * points);
  std::vector<std::uint16_t> tool(2 * points);
  std::vector<std::uint32_t> lines(points), corners(3 * triangles);
  const char* from = frame.data() + 16;
  const auto take = [&](auto& column) {
    std::memcpy(column.data(), from, column.size() * sizeof column[0]), from += column.size() * sizeof column[0];
  };
  take(at), take(corners), take(tool), take(lines);
  for (const std::uint32_t corner : corners) ASSERT_LT(corner, points);
  std::size_t of_blank_points = 0, of_groove = 0;
  float least = 1e9F;
  for (std::size_t i = 0; i < points; ++i) {
    least = std::min(least, at[3 * i]);
    of_blank_points += tool[2 * i] == 65535 && lines[i] == 0;
    of_groove += tool[2 * i] == 1 && lines[i] == 7;
    ASSERT_TRUE((tool[2 * i] == 65535) == (lines[i] == 0));
  }
  EXPECT_GT(of_blank_points, 1000U);
  EXPECT_GT(of_groove, 1000U);
  EXPECT_NEAR(least, -110, 0.01) << "machine coordinates: X0 of the program is X-100 of the machine";
}

TEST(PartRun, WhatIsRefused) {
  const OpenedProgram program = opened(text);
  for (const char* stock : {"", "box:0,0,0,1,1", "box:0,0,0,nan,1,1", "box:0,0,0,1e300,1,1", "nothing.stl"})
    EXPECT_FALSE(PartRun::make(program, wish_for(stock), {})) << stock;
  for (const double resolution : {1e-9, 1e9, std::nan(""), -1.0})
    EXPECT_FALSE(PartRun::make(program, wish_for(block, resolution), {})) << resolution;
  EXPECT_FALSE(PartRun::make(program, wish_for("box:0,0,0,1000,1000,1000", 0.1), {})) << "more memory than there may be";
  PartRequest fixture = wish_for(block);
  fixture.fixtures = {"ball"}, fixture.fixture_names = {"ball"};
  EXPECT_FALSE(PartRun::make(program, fixture, {}));
}

TEST(PartRun, GreatBodiesGetGreatCells) {
  const OpenedProgram program = opened(text);
  auto run = PartRun::make(program, wish_for("box:-1e5,-1e5,-1e5,1e5,1e5,1e5", 0), {});
  ASSERT_TRUE(run) << run.error();
  ASSERT_TRUE((*run)->execute());
  EXPECT_GE((*run)->result().cell, 250);
}

TEST(PartRun, IsStopped) {
  std::atomic<bool> stops = true;
  const OpenedProgram program = opened(text);
  auto run = PartRun::make(program, wish_for(block), StopToken(stops));
  ASSERT_TRUE(run) << run.error();
  EXPECT_FALSE((*run)->execute());
}

TEST(PartRun, AToolWithoutShape) {
  const OpenedProgram program = opened(text);
  PartRequest request = wish_for(block);
  request.tools.tools.pop_back();
  auto run = PartRun::make(program, request, {});
  ASSERT_TRUE(run) << run.error();
  const auto done = (*run)->execute();
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().find("13"), std::string::npos) << done.error();
}

}  // namespace
}  // namespace kadr::part_run_test
