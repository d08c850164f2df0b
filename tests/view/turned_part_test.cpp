// The turned part of a page: at its end it equals the result of `kadr cut`, at any instant the part cut until then. Also: who made the
// surface, sections, threads, inserts, and what is cut on a lattice instead.

#include "view/turned_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "config/tools/tool_list.h"
#include "session/cutting/cut_setup.h"
#include "view/turned_json.h"

namespace kadr::turned_part_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr const char* text =
    "O1\n"
    "G21 G40 G97 S500 M3\n"
    "T0101\n"
    "G0 X44. Z2.\n"
    "G1 X40. F0.2\n"
    "Z-30.\n"       // line 6: a cylinder of 40
    "G4 X3.\n"      // 3 s
    "X60. Z-40.\n"  // line 8: a cone
    "G0 X60. Z2.\n"
    "G4 X3.\n"
    "X30.\n"
    "G1 Z-20.\n"  // line 12: a step of 30
    "X62.\n"
    "G4 X3.\n"
    "G0 Z3. T0303\n"
    "G0 X34. Z3.\n"
    "G92 X29. Z-15. F2.\n"  // line 17: a thread
    "X28.\n"
    "M30\n";
constexpr const char* tools = R"([
  {"number": 1, "kind": "turning", "points": "-x-z", "corner": 0.4, "angle": 80, "lead": 95, "flute_length": 12},
  {"number": 3, "kind": "turning", "points": "-x", "angle": 60, "flute_length": 6}])";
constexpr const char* bar = "cylinder:0,0,-60,0,60";

OpenedProgram opened(const std::string& program, const std::string& control = "fanuc-t") {
  OpeningRequest request;
  request.path = "turned_part_test.nc";
  request.control = control;
  request.text = program;
  auto made = open_for_page(request);
  EXPECT_TRUE(made) << made.error();
  return *made;
}

PartRequest wish_for(const std::string& stock = bar, double resolution = 0) {
  PartRequest request;
  request.stock = stock;
  request.tools = *tools_of_list(tools);
  request.resolution = resolution;
  return request;
}

std::unique_ptr<PartRun> cut(const OpenedProgram& program, const PartRequest& request = wish_for()) {
  auto run = PartRun::make(program, request, {});
  EXPECT_TRUE(run) << run.error();
  if (!run) return nullptr;
  const auto done = (*run)->execute();
  EXPECT_TRUE(done) << done.error();
  return std::move(*run);
}

/// Returns what a cut leaves whose motions all begin before an instant, computed as by `kadr cut`.
double left_until(const OpenedProgram& program, double until) {
  CutJob job;
  job.tools = *tools_of_list(tools);
  job.until = until;
  auto session = Session::open(program.spec(*program.program(), {}));
  take_session(**session, false, job);
  TurnedRun run(**session, job, *turned_job_of(program.machine, program.setup, bar, {}));
  run.attach({});
  (void)(*session)->run();
  run.finish();
  return run.cutting().stock().volume();
}

/// Returns the instants in the middle of the dwells of 3 s.
std::vector<double> dwells(const OpenedProgram& program) {
  auto session = Session::open(program.spec(*program.program(), {}));
  const auto& axes = (*session)->control().axes();
  TimeEstimate clock(AxisRoles::of(axes, {}), rates_of((*session)->machine(), (*session)->setup(), axes));
  std::vector<double> all;
  (*session)->outlets().clock = &clock;
  (*session)->outlets().step = [&](const Step& step) {
    if (std::fabs(step.pause - 3) < 1e-6) all.push_back(step.begins + step.pause / 2);
  };
  (*session)->change_outlets();
  (void)(*session)->run();
  return all;
}

TEST(TurnedPart, EndsAsTheCommandDoes) {
  const OpenedProgram program = opened(text);
  const auto run = cut(program);
  ASSERT_TRUE(run);
  ASSERT_TRUE(run->result().turned);
  EXPECT_EQ(run->result().left, left_until(program, 1e300));
  EXPECT_EQ(run->at(1e300).left, run->result().left);
  EXPECT_EQ(run->result().threads.size(), 1U);
  EXPECT_NEAR(run->at(-1).left, 30 * 30 * pi * 60, 1e-6);
}

TEST(TurnedPart, AnyInstantIsAsIfCutUntilThen) {
  const OpenedProgram program = opened(text);
  const auto run = cut(program);
  const auto instants = dwells(program);
  ASSERT_EQ(instants.size(), 3U);
  for (const double instant : instants) {
    const PartThen then = run->at(instant);
    EXPECT_EQ(then.seconds, instant);
    EXPECT_NEAR(then.left, left_until(program, instant), 1e-3) << instant;
  }
  double before = run->result().stock;
  for (int i = 0; i <= 200; ++i) {
    const double left = run->at(run->result().seconds * i / 200).left;
    EXPECT_LE(left, before + 1e-6) << i;
    before = left;
  }
}

TEST(TurnedPart, TheSurfaceEnclosesThePart) {
  const auto program = opened(text);
  const auto run = cut(program);
  for (const double share : {0.0, 0.3, 0.6, 0.8}) {  // before the thread
    const PartThen then = run->at(share * run->result().seconds);
    EXPECT_NEAR(volume_of(then.surface), then.left, 2 * then.cell * area_of(then.surface)) << share;
  }
  double least = 20;
  const Surface end = run->at(1e300).surface;
  for (std::size_t i = 0; i < end.point_count(); ++i)
    if (const Vec3 p = end.point(i); p.z > -14 && p.z < -1) least = std::min(least, std::hypot(p.x, p.y));
  EXPECT_NEAR(least, 14, 1e-3) << "the root of the thread";
}

TEST(TurnedPart, TheFrameSaysWhoMadeEachPoint) {
  const auto program = opened(text);
  const auto run = cut(program);
  const PartThen then = run->at(1e300);
  const std::string frame = run->frame_of(then);
  std::uint32_t head[4];
  std::memcpy(head, frame.data(), sizeof head);
  const std::size_t points = head[2];
  ASSERT_EQ(frame.size(), 16 + 20 * points + 12 * std::size_t(head[3]));
  std::vector<float> at(3 * points);
  std::vector<std::uint16_t> tool(2 * points);
  std::vector<std::uint32_t> line(points);
  std::memcpy(at.data(), frame.data() + 16, 12 * points);
  std::memcpy(tool.data(), frame.data() + 16 + 12 * points + 12 * std::size_t(head[3]), 4 * points);
  std::memcpy(line.data(), frame.data() + 16 + 16 * points + 12 * std::size_t(head[3]), 4 * points);
  std::map<std::uint32_t, std::size_t> by_line;
  for (std::size_t i = 0; i < points; ++i) {
    const double radius = std::hypot(double(at[3 * i]), double(at[3 * i + 1])), z = double(at[3 * i + 2]);
    ++by_line[line[i]];
    if (line[i] == 6) {
      EXPECT_NEAR(radius, 20, 0.41) << z;
    }
    if (line[i] == 8) {
      EXPECT_NEAR(radius, 20 + (-30 - z), 0.5) << z;
    }
    if (tool[2 * i] == 3) {
      EXPECT_TRUE(line[i] == 17 || line[i] == 18);
    }
    if (line[i] == 0) {
      EXPECT_EQ(tool[2 * i], 65535);
    }
  }
  for (const std::uint32_t one : {0U, 6U, 8U, 12U, 18U}) EXPECT_GT(by_line[one], 0U) << one;
}

TEST(TurnedPart, SectionsShowTheTeethOfTheThread) {
  const auto program = opened(text);
  const auto run = cut(program);
  const PartThen then = run->at(1e300);
  ASSERT_EQ(then.section.size(), 1U);
  const auto teeth = [](const TurnedRegion& section) {
    std::vector<double> roots;
    const TurnedPolygon& p = section[0];
    for (std::size_t i = 1; i + 1 < p.size(); ++i)
      if (p[i].x < p[i - 1].x && p[i].x <= p[i + 1].x && p[i].x < 14.2 && p[i].x > 1 && p[i].y > -15) roots.push_back(p[i].y);
    return roots;
  };
  const auto at_x = teeth(then.section), at_y = teeth(then.section_y);
  ASSERT_GT(at_x.size(), 5U);
  for (std::size_t i = 1; i < at_x.size(); ++i) EXPECT_NEAR(at_x[i] - at_x[i - 1], 2, 0.15);
  EXPECT_NEAR(std::remainder(at_y[0] - at_x[0] - 0.5, 2.0), 0, 0.15) << "a right-handed helix: a quarter turn on, a quarter lead along +Z";
  EXPECT_TRUE(run->at(0).section_y == run->at(0).section);
  const auto json = turned_json(then, 100);
  EXPECT_EQ(json["section"][0].size(), then.section[0].size());
  EXPECT_NEAR(json["edges"][0][1].get<double>(), then.edges[0].y + 100, 1e-4);
}

TEST(TurnedPart, EdgesAreWhereADrawingHasLines) {
  const auto program = opened(text);
  const auto run = cut(program);
  const auto edges = run->at(0).edges;
  ASSERT_EQ(edges.size(), 2U) << "the two faces of the bar";
  for (const Vec2 edge : edges) EXPECT_EQ(edge.x, 30);
}

TEST(TurnedPart, InsertsAreThoseUsed) {
  const auto program = opened(text);
  const auto run = cut(program);
  const auto inserts = run->inserts();
  ASSERT_EQ(inserts.size(), 2U);
  EXPECT_EQ(inserts[0].tool, 1U);
  EXPECT_EQ(inserts[1].tool, 3U);
  EXPECT_EQ(inserts[1].part, ToolPart::cutting);
  double least = 1;
  for (const Vec2 p : inserts[1].outline) least = std::min(least, p.x);
  EXPECT_NEAR(least, 0, 1e-9) << "the tip is the programmed point";
}

TEST(TurnedPart, OthersAreCutOnALattice) {
  const auto program = opened(text);
  EXPECT_FALSE(cut(program, wish_for("box:-30,-30,-60,30,30,0"))->result().turned);
  EXPECT_FALSE(cut(program, wish_for(bar, 1))->result().turned) << "a resolution is asked for";
  EXPECT_TRUE(cut(program, wish_for("cylinder:0,0,-60,0,60,10"))->result().turned) << "a tube";
  const auto broken = PartRun::make(program, wish_for("cylinder:0,0,0,0,60"), {});
  EXPECT_FALSE(broken);
}

TEST(TurnedPart, AToolWithoutFormStopsTheCut) {
  const auto program = opened("O1\nT0707\nG97 S500 M3\nG0 X70. Z2.\nG1 X50. F0.2\nZ-5.\nM30\n");
  auto run = PartRun::make(program, wish_for(), {});
  ASSERT_TRUE(run);
  const auto done = (*run)->execute();
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().find("5"), std::string::npos) << done.error();
}

}  // namespace
}  // namespace kadr::turned_part_test
