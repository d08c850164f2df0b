// out/picture/plot/plot: bounded memory, extents, several work coordinate systems, both file formats.

#include "out/picture/plot/plot.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "actions.h"
#include "motion/time/steps.h"
#include "out/picture/plot/plot_view.h"
#include "out/picture/text_width.h"
#include "out/text/page_file.h"

namespace kadr::plot_test {
namespace {

using test::action;
using test::arc;
using test::straight;
using enum MotionKind;

const std::vector<std::string> names = {"X", "Y", "Z"};

const AxisRoles roles = AxisRoles::of(names, 0);

/// Draws actions that begin at `start`.
void draw(Plot& plot, const std::vector<Action>& actions, const AxisRoles& of = roles, const ToolPosition& start = {}) {
  Steps steps(of, start);
  for (const Action& a : actions) steps.give(a, [&](const Step& step) { plot.consume(step); });
}

Plot small_part() {
  Plot plot(names, 0, {});
  draw(plot,
       {action(straight(rapid, {10, 0, 5})), action(straight(feed, {10, 0, -2}, 100)), action(arc(arc_ccw, {10, 0, -2}, {0, 0, 0}, 1))});
  return plot;
}

TEST(plot, keeps_the_path_and_its_extents) {
  const Plot plot = small_part();
  EXPECT_EQ(plot.path().tolerance(), 0);
  EXPECT_EQ(plot.path().points()[2].stroke, Stroke::plunge);
  EXPECT_NEAR(plot.path().cutting_box().least.x, -10, 0.02);
  EXPECT_EQ(plot.path().box().most, (Vec3{10, plot.path().box().most.y, 5}));
}

TEST(plot, work_systems_stand_where_they_are_on_the_machine) {
  Plot plot(names, 0, {});
  std::vector<Action> program;
  for (const double origin : {100.0, 300.0}) {
    program.push_back({{}, FrameChange{{.origin = {origin, 0, 0}}, {}}});
    Motion m = straight(feed, {10, 0, 0}, 100);
    m.machine[0] += origin;
    program.push_back(action(m));
  }
  draw(plot, program);
  EXPECT_EQ(plot.path().points().back().at, (Vec3{210, 0, 0}));
  ASSERT_EQ(plot.zeros().size(), 2U);
  EXPECT_EQ(plot.zeros()[1], (Vec3{200, 0, 0}));
}

RC_GTEST_PROP(plot_path, never_holds_more_than_it_may, ()) {
  const std::size_t most = *rc::gen::inRange<std::size_t>(10, 500);
  const double size = *rc::gen::inRange(0, 1000) / 10.0;
  PlotPath path(most);
  path.start({});
  Box box;
  for (int i = 0; i < 5000; ++i) {
    const double t = i * 0.7;
    const Vec3 p{size * std::sin(t), size * std::cos(t * 1.3), i % 5 * 0.1};
    box.take(p);
    path.go(p, static_cast<Stroke>(i % 4));
    RC_ASSERT(path.points().size() <= most);
  }
  RC_ASSERT(path.tolerance() > 0);
  RC_ASSERT(path.box().most.x >= box.most.x && path.box().least.y <= box.least.y);  // the extents are still exact
}

TEST(plot, the_box_is_that_of_the_arcs_not_of_their_chords) {
  const Plot plot = small_part();
  EXPECT_DOUBLE_EQ(plot.path().cutting_box().least.x, -10);
  EXPECT_DOUBLE_EQ(plot.path().cutting_box().most.y, 10);
}

TEST(plot, a_view_shows_the_programmed_contour_whole_and_rapid_motion_that_is_not_far) {
  PlotPath path, contour;
  path.start({0, 0, 0});
  path.go({100, 0, 0}, Stroke::feed);
  path.go({100, 150, 0}, Stroke::rapid);
  path.go({0, 0, 900}, Stroke::rapid);
  contour.start({-30, -20, 0});
  contour.go({60, -20, 0}, Stroke::contour);
  const PlotTitle title{};
  const PlotScene scene{path, contour, {}, {}, title, ShadeScale(PlotColour::stroke, path)};
  const Box box = shown_box(scene, 4);
  EXPECT_EQ(box.least, (Vec3{-30, -20, 0}));
  EXPECT_EQ(box.most, (Vec3{100, 150, 32.5})) << "the cutting and the contour are 130 wide: Y 170 is within four times, Z 900 is not";
}

TEST(text_width, printable_texts) {
  EXPECT_EQ(printable("a\tb\x7F"), "a␉b␡");
  EXPECT_EQ(printable("\xC0\x80 \xED\xA0\x80 \xEF\xBF\xBE \xF4\x90\x80\x80 \xD0"),
            "\xEF\xBF\xBD\xEF\xBF\xBD \xEF\xBF\xBD \xEF\xBF\xBD \xEF\xBF\xBD \xEF\xBF\xBD");
  EXPECT_EQ(printable("деталь №1 ⌀ 𝄞"), "деталь №1 ⌀ 𝄞");
}

TEST(text_width, widths) {
  EXPECT_DOUBLE_EQ(text_width("A", 1000), 684);
  EXPECT_DOUBLE_EQ(text_width("АЯ", 10), 6.84 + 6.95);
  EXPECT_DOUBLE_EQ(text_width("", 10), 0);
}

TEST(plot_view, round_steps) {
  EXPECT_DOUBLE_EQ(round_step(0.7), 1);
  EXPECT_DOUBLE_EQ(round_step(1.2), 2);
  EXPECT_DOUBLE_EQ(round_step(20), 20);
  EXPECT_DOUBLE_EQ(round_step(0.031), 0.05);
  EXPECT_DOUBLE_EQ(round_step(7), 10);
}

TEST(plot_view, a_fitted_box_stays_in_its_area) {
  const Area area{100, 50, 400, 300};
  const Box box{{-10, 5, -3}, {90, 35, 0}, false};
  for (const View view : {View::isometric, View::xy, View::xz, View::yz}) {
    const ViewScale scale = fitted(view, box, area);
    for (const Vec3 p : {box.least, box.most}) {
      const Vec2 at = scale.page(projected(view, p));
      EXPECT_GE(at.x, area.x - 1e-9);
      EXPECT_LE(at.x, area.right() + 1e-9);
      EXPECT_GE(at.y, area.y - 1e-9);
      EXPECT_LE(at.y, area.bottom() + 1e-9);
    }
  }
}

TEST(plot, surfaces_are_drawn_by_their_linear_axes) {
  const std::vector<std::string> axes = {"X", "Z", "C"};
  const ToolPosition start{{50, 0, 0}, {50, 0, 0}};
  Plot plot(axes, 4, start);
  MotionDetail detail;
  detail.surface = PathSurface::polar;
  detail.flat_from = {50, 1};
  detail.flat_to = {-50, 1};
  Motion m = straight(feed, {50, -10, 178}, 1000);
  m.second = 2;
  m.detail = std::make_shared<MotionDetail>(detail);
  draw(plot, {action(m)}, AxisRoles::of(axes, 4), start);
  EXPECT_NEAR(plot.path().cutting_box().least.x, 1, 0.02);
  EXPECT_NEAR(plot.path().cutting_box().most.z, 0, 1e-9);
  EXPECT_EQ(plot.path().points().back().stroke, Stroke::feed);
}

TEST(plot, writes_svg_and_png) {
  const auto folder = std::filesystem::temp_directory_path();
  for (const char* name : {"kadr_plot_test.svg", "kadr_plot_test.png"}) {
    const std::string file = (folder / name).string();
    auto page = ResultFile::open(file);
    ASSERT_TRUE(page);
    const auto done = small_part().write(*page, {"part.nc", "2С42-65", Lang::ru});
    ASSERT_TRUE(done) << done.error();
    ASSERT_TRUE(page->keep());
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_NE(bytes.substr(0, 100).find(name[15] == 's' ? "<svg" : "PNG"), std::string::npos);
    std::filesystem::remove(file);
  }
  EXPECT_EQ(page_fault("a.pdf"), "a.pdf: a plot is .svg or .png");
}

// A lathe is drawn with Z to the right and X upwards, in true lengths; the numbers along X are diameters if the program has them.
TEST(plot, a_lathe_has_one_view) {
  const std::vector<std::string> xz = {"X", "Z"};
  Plot plot(xz, 0, {});
  draw(plot, {action(straight(rapid, {20, 2, 0})), action(straight(feed, {20, -30, 0}, 100)), action(straight(feed, {25, -30, 0}, 100))},
       AxisRoles::of(xz, 0));
  EXPECT_EQ(plot.path().points()[2].stroke, Stroke::feed) << "along Z a lathe turns, it does not plunge";
  EXPECT_EQ(projected(View::zx, {25, 0, -30}), (Vec2{-30, 25}));
  const auto svg = [&](bool diameters) {
    const std::string file = (std::filesystem::temp_directory_path() / "kadr_plot_of_a_lathe.svg").string();
    PlotTitle title{"shaft.nc", "control"};
    title.x_is_diameter = diameters;
    auto page = ResultFile::open(file);
    EXPECT_TRUE(page && plot.write(*page, title) && page->keep());
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::filesystem::remove(file);
    return text;
  };
  const std::string with_diameters = svg(true), with_radii = svg(false);
  EXPECT_NE(with_diameters.find("view-zx"), std::string::npos);
  EXPECT_EQ(with_diameters.find("view-xy"), std::string::npos);
  EXPECT_EQ(with_diameters.find("view-isometric"), std::string::npos);
  EXPECT_NE(with_diameters.find(">X Ø<"), std::string::npos);
  EXPECT_EQ(with_radii.find("Ø"), std::string::npos);
  EXPECT_NE(with_diameters.find(">50<"), std::string::npos) << "the radius 25";
}

TEST(plot, without_motion_it_says_so) {
  const std::string file = (std::filesystem::temp_directory_path() / "kadr_plot_empty.png").string();
  const auto page = ResultFile::open(file);
  ASSERT_TRUE(page);
  EXPECT_TRUE(Plot(names, 0, {}).write(*page, {"empty.nc", "Mach3", Lang::en}));
}

}  // namespace
}  // namespace kadr::plot_test
