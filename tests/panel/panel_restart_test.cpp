// panel/panel_search, panel_sheet, panel_restart: a restart in mid program.

#include <algorithm>
#include <cmath>
#include <tuple>

#include "panel/a_panel.h"
#include "session/cutting/cutting.h"
#include "stock/surface/surface.h"

namespace kadr::panel_restart_test {
namespace {

using test::APanel;
using test::expect_at;
using Kind = InForce::Kind;

/// Returns what the search finds. The limit is generous, because the test machine may be busy.
PanelSearch::Answer found(const APanel& panel, const PanelSearch::SearchRequest& request) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (true) {
    PanelSearch::Answer answer = panel->find(request);
    if (answer.ready || std::chrono::steady_clock::now() > end) return answer;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

std::optional<PanelSheet> sheet_at(const APanel& panel, const PanelSearch::SearchRequest& request,
                                   const WayRules& rules = {.clearance = 30, .above = 2, .feed = 600}) {
  const auto place = found(panel, request);
  EXPECT_TRUE(place.place) << place.error;
  if (!place.place) return std::nullopt;
  auto sheets = panel->sheets(place.place, rules);
  EXPECT_TRUE(sheets) << sheets.error();
  return sheets ? std::optional(std::move(sheets->front())) : std::nullopt;
}

void go_to(const APanel& panel, const PanelSearch::SearchRequest& request, const std::set<std::string>& left = {}) {
  const auto sheet = sheet_at(panel, request);
  ASSERT_TRUE(sheet);
  const auto went = panel->go_there(found(panel, request).place, left, {{0, sheet->path}});
  ASSERT_TRUE(went) << went.error();
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && !s.goes_there; }));
}

const PanelSheet::Row* row(const PanelSheet& sheet, const std::string& key) {
  for (const PanelSheet::Row& one : sheet.rows)
    if (key_of(one.required ? *one.required : *one.now) == key) return &one;
  return nullptr;
}

std::string code_in_force(const APanel& panel, Kind kind) {
  for (const InForce& one : panel->state().block.modes->in_force)
    if (one.kind == kind) return one.code;
  return {};
}

const char* const program =
    "G21 G90 G94 G17 G54\n"  // 1
    "T5 M6\n"
    "S800 M3\n"
    "G0 X10 Y20 Z30\n"
    "M8\n"  // 5
    "G1 Z-3 F6000\n"
    "X30\n"
    "#100=7\n"
    "Y40\n"
    "M9\n"  // 10
    "G0 Z30\n"
    "M5\n"
    "M30\n";

TEST(PanelRestart, TheSheetTellsWhatIsOtherwise) {
  const APanel panel(program);
  const auto sheet = sheet_at(panel, {.target = {.line = 9}});
  ASSERT_TRUE(sheet);
  EXPECT_EQ(row(*sheet, "tool:")->required->value, 5);
  EXPECT_EQ(row(*sheet, "tool:")->now->value, 0);
  EXPECT_EQ(row(*sheet, "tool:")->by, PanelSheet::By::line);
  EXPECT_FALSE(row(*sheet, "tool:")->may_be_left) << "no line says that none is in the spindle";
  EXPECT_TRUE(row(*sheet, "spindle:")->may_be_left);
  EXPECT_EQ(row(*sheet, "spindle:")->required->code, "M3");
  EXPECT_EQ(row(*sheet, "machine:X")->required->value, 30);
  EXPECT_EQ(row(*sheet, "machine:X")->by, PanelSheet::By::path);
  EXPECT_FALSE(row(*sheet, "machine:X")->may_be_left);
  EXPECT_EQ(row(*sheet, "variable:#100")->by, PanelSheet::By::memory);
  EXPECT_EQ(row(*sheet, "origin:X")->by, PanelSheet::By::nothing);
  ASSERT_EQ(sheet->path.size(), 4u);
  EXPECT_EQ(sheet->path.front().machine[2], 30);
  EXPECT_EQ(sheet->path[2].machine[2], -1);
  EXPECT_FALSE(sheet->path[3].rapid);
}

TEST(PanelRestart, GoesOnAsIfItHadRun) {
  const APanel panel(program);
  go_to(panel, {.target = {.line = 9}});
  expect_at(panel, {30, 20, -3});
  EXPECT_EQ(panel.line(), 9u);
  EXPECT_EQ(panel->state().why, "restart");
  EXPECT_EQ(code_in_force(panel, Kind::spindle), "M3");
  EXPECT_EQ(code_in_force(panel, Kind::coolant), "M8");
  EXPECT_FALSE(panel->undo()) << "nothing leads back behind it";
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.stands(PanelMode::ended));
  expect_at(panel, {30, 40, 30});
}

TEST(PanelRestart, WhatIsLeftStaysAsItIs) {
  const APanel panel(program);
  const auto sheet = sheet_at(panel, {.target = {.line = 9}});
  go_to(panel, {.target = {.line = 9}}, {"spindle:", "variable:#100", "machine:X"});
  expect_at(panel, {30, 20, -3});
  ASSERT_TRUE(panel->set_single(true));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 10; }));
  EXPECT_EQ(code_in_force(panel, Kind::spindle), "M5");
}

TEST(PanelRestart, APlaceThatIsNotReachedIsTold) {
  const APanel panel(program);
  for (const StopPoint& nowhere : {StopPoint{.line = 99}, StopPoint{.line = 9, .pass = 2}, StopPoint{.line = 9, .call = "O7"}}) {
    const auto answer = found(panel, {.target = nowhere});
    EXPECT_TRUE(answer.ready);
    EXPECT_FALSE(answer.place);
    EXPECT_FALSE(answer.error.empty());
  }
}

TEST(PanelRestart, AWayThatEndsElsewhereOrOutsideIsRefused) {
  const APanel panel(program);
  const auto place = found(panel, {.target = {.line = 9}}).place;
  ASSERT_TRUE(place);
  EXPECT_FALSE(panel->go_there(place, {}, {}));
  const auto sheet = sheet_at(panel, {.target = {.line = 9}});
  auto path = sheet->path;
  path[0].machine[2] = 501;
  EXPECT_FALSE(panel->go_there(place, {}, {{0, path}})) << "beyond the end of the axis";
  path = sheet->path;
  path.back().feed = 0;
  EXPECT_FALSE(panel->go_there(place, {}, {{0, path}}));
  EXPECT_EQ(panel->state().mode, PanelMode::standing);
}

TEST(PanelRestart, OverAHoleOfACycle) {
  const APanel panel("G21 G90 G17\nG0 X0 Y0 Z10\nG91 G81 X10 Y0 Z-5 R-8 F6000 L5\nG80\nM30\n");
  go_to(panel, {.target = {.line = 3}, .hole = 4});
  EXPECT_NEAR(panel.at().x, 40, 1e-9);
  EXPECT_EQ(panel.line(), 3u);
  ASSERT_TRUE(panel->set_single(true));
  ASSERT_TRUE(panel->run());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 4; }))
      << "the rest of the cycle is one block";
  EXPECT_NEAR(panel.at().x, 50, 1e-9);
}

TEST(PanelRestart, APlaceByItsNumberInTheRun) {
  const APanel panel("G21 G91\n#1=0\nM98 P7 L30\nM30\nO7\n#1=[#1+1]\nG0 X1\nM99\n");
  const auto third = found(panel, {.target = {.line = 7, .pass = 3}}).place;
  ASSERT_TRUE(third);
  const auto same = found(panel, {.target = {.line = 7, .number = third->restart.at.number}}).place;
  ASSERT_TRUE(same);
  EXPECT_EQ(same->restart.stand.machine[0], 2);
  EXPECT_FALSE(found(panel, {.target = {.line = 6, .number = third->restart.at.number}}).place);
}

TEST(PanelRestart, AStopOnTheWayThereIsObeyed) {
  const APanel panel(program);
  const auto sheet = sheet_at(panel, {.target = {.line = 9}});
  auto path = sheet->path;
  for (WayPoint& point : path) point.rapid = false, point.feed = 600;
  ASSERT_TRUE(panel->go_there(found(panel, {.target = {.line = 9}}).place, {}, {{0, path}}));
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.sample.machine[2] > 2; }));
  ASSERT_TRUE(panel->hold());
  ASSERT_TRUE(panel.stands(PanelMode::held));
  EXPECT_TRUE(panel->state().goes_there);
  ASSERT_TRUE(panel->reset());
  ASSERT_TRUE(panel.until([](const PanelState& s) { return s.mode == PanelMode::standing && !s.goes_there; }));
  EXPECT_EQ(panel.line(), 1u);
  EXPECT_LT(panel.at().z, 30);
}

TEST(PanelRestart, ALineThatCannotBeCarriedOutStopsTheWay) {
  const APanel panel("G21 G90\nT5 M6\nM3\nG1 X10 F100\nM30\n", "mach3");
  const auto place = found(panel, {.target = {.line = 4}}).place;
  ASSERT_TRUE(place);
  panel->stop_at_once();
  ASSERT_TRUE(panel.stands(PanelMode::emergency));
  EXPECT_FALSE(panel->go_there(place, {}, {}));
  EXPECT_FALSE(panel->sheets(place, {}));
}

// ---- the part

/// The material, cut by everything that the machine does.
class APart {
 public:
  APart() : roles_(AxisRoles::of({"X", "Y", "Z"}, 0)), cutting_(job(), roles_) {}
  void take(const Step& step) { EXPECT_TRUE(cutting_.consume(step, {step.begins, step.time.seconds})); }
  /// Returns the remaining stock.
  Mesh left() {
    cutting_.finish();
    return surface_of(cutting_.stock());
  }

 private:
  static CutJob job() {
    ToolGeometry tool;
    tool.number = 1, tool.diameter = 6, tool.flutes = 25, tool.length = 50;
    CutJob job;
    job.blank = box_blank({{-10, -10, -20}, {60, 60, 0}});
    job.tools.tools = {tool};
    job.cell = 0.5;
    job.starts_known = true;
    return job;
  }
  AxisRoles roles_;
  Cutting cutting_;
};

/// Twice around a square, deeper each time, with compensated corners.
const char* const pocket =
    "G21 G90 G94 G17\n"  // 1
    "#1=0\n"
    "T1 M6\n"
    "S900 M3\n"
    "G0 X-20 Y-20 Z20\n"  // 5
    "M98 P7 L2\n"
    "G0 Z50\n"
    "M30\n"
    "O7\n"
    "#1=[#1-1]\n"  // 10
    "G0 X-20 Y-20\n"
    "G1 Z#1 F24000\n"
    "G42 D1 X0 Y0\n"
    "X40\n"
    "Y40\n"  // 15
    "X0\n"
    "Y0\n"
    "G40 X-20 Y-20\n"
    "G0 Z20\n"
    "M99\n";  // 20

Setup with_radius() {
  Setup setup;
  setup.offsets[1].radius = 3;
  return setup;
}

std::vector<Vec3> sorted(const Mesh& mesh) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < mesh.point_count(); ++i) points.push_back(mesh.point(i));
  std::sort(points.begin(), points.end(), [](Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  return points;
}

/// The program is broken off in the second pass of a subprogram under cutter compensation; after the restart the part is the same.
TEST(PanelRestart, TheSamePartInTheSecondPassUnderCompensation) {
  APart whole;
  const APanel unbroken(pocket, "mach3", with_radius());
  unbroken->watch([&](const Step& step) { whole.take(step); });
  ASSERT_TRUE(unbroken->run());
  ASSERT_TRUE(unbroken.stands(PanelMode::ended));
  const Mesh expected = whole.left();
  ASSERT_LT(volume_of(expected), 70 * 70 * 20 - 100);

  for (const std::uint32_t line : {14U, 15U, 16U, 18U}) {
    APart part;
    const APanel broken(pocket, "mach3", with_radius());
    broken->watch([&](const Step& step) { part.take(step); });
    ASSERT_TRUE(broken->add_stop({.line = line, .pass = 2}));
    ASSERT_TRUE(broken->run());
    ASSERT_TRUE(broken.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.hit != 0; }));
    ASSERT_TRUE(broken->reset());
    ASSERT_TRUE(broken.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.line.number == 1; }));
    ASSERT_TRUE(broken->jog("Z", 15, 0));
    ASSERT_TRUE(broken.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[2] > 12; }));
    ASSERT_TRUE(broken->jog("X", -70, 0));  // in the air: here the operator changes the tool
    ASSERT_TRUE(broken.until([](const PanelState& s) { return s.mode == PanelMode::standing && s.sample.machine[0] < -20; }));
    go_to(broken, {.target = {.line = line, .pass = 2}});
    EXPECT_EQ(broken->state().block.modes->calls.size(), 1u);
    ASSERT_TRUE(broken->remove_stop(1));
    ASSERT_TRUE(broken->run());
    ASSERT_TRUE(broken.stands(PanelMode::ended));
    const Mesh left = part.left();
    EXPECT_NEAR(volume_of(left), volume_of(expected), 1e-3) << line;
    const auto a = sorted(left), b = sorted(expected);
    ASSERT_EQ(a.size(), b.size()) << line;
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_LT(length(a[i] - b[i]), 1e-3) << line;
  }
}

}  // namespace
}  // namespace kadr::panel_restart_test
