// A drawing becomes a program: what each step refuses, with the line of the fault, and the properties of the result.

#include "session/milling/milling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "config/control/control_file.h"
#include "session/milling/mill_summary.h"

namespace kadr::milling_test {
namespace {

const char* const zone = "from 0 0\nline 60 0\nline 60 40\nline 0 40\nclose\n";

MillRequest pocket() {
  MillRequest request;
  request.task = "pocket";
  request.tool_diameter = 8;
  request.depth = 4;
  return request;
}

tl::expected<Milled, DrawingFault> made(const MillRequest& request, const char* drawing, const area::Watch& watch = {}) {
  return milled(request, drawing, *load_control("mach3"), watch);
}

TEST(Milling, APocketIsCutToItsDepthAndNoFurther) {
  const auto program = made(pocket(), zone);
  ASSERT_TRUE(program);
  EXPECT_NEAR(program->path.outcome.nearest_wall, 4, 0.002);
  EXPECT_FALSE(program->program.text.empty());
  double deepest = 0;
  for (const area::Move& move : program->program.moves) deepest = std::min(deepest, move.to.z);
  EXPECT_EQ(deepest, -4);
}

TEST(Milling, ValuesThatAreNoneAreTold) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const double value : {0.0, nothing, 1e300, std::numeric_limits<double>::infinity()}) {
    MillRequest request = pocket();
    request.depth = value;
    const auto program = made(request, zone);
    ASSERT_FALSE(program) << value;
    EXPECT_EQ(program.error().alarm.id, AlarmId::mill_value);
    EXPECT_EQ(program.error().line, 0U);
  }
  MillRequest request = pocket();
  request.scheme = "round";
  EXPECT_EQ(made(request, zone).error().alarm.args[0].text(), "scheme");
}

TEST(Milling, AFaultOfTheDrawingHasItsLine) {
  const char* const torn = "from 0 0\nline 60 0\nline 60 40\n";
  const auto program = made(pocket(), torn);
  ASSERT_FALSE(program);
  const AlarmReport report = report_of(program.error(), torn, "torn.txt");
  EXPECT_EQ(report.alarm.id, AlarmId::contour_open_end);
  EXPECT_EQ(report.origin.line, 3U);
  EXPECT_EQ(report.line_text, "line 60 40");
}

TEST(Milling, WhoeverWaitsMayEndIt) {
  const std::atomic<bool> stops = true;
  const auto program = made(pocket(), zone, {StopToken(stops), {}});
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error().alarm.id, AlarmId::interrupted);
}

TEST(Milling, ALineIsASlotAsWideAsTheTool) {
  MillRequest request = pocket();
  request.task = "slot";
  const auto narrow = made(request, "from 0 0\nline 50 0\n");
  ASSERT_TRUE(narrow);
  EXPECT_EQ(narrow->shape.lines.size(), 1U);
  request.width = 12;
  const auto wide = made(request, "from 0 0\nline 50 0\n");
  ASSERT_TRUE(wide);
  EXPECT_TRUE(wide->shape.lines.empty());
}

TEST(Milling, ThePictureInMemoryIsAWholePage) {
  const auto program = made(pocket(), zone);
  ASSERT_TRUE(program);
  const std::string svg = milling_svg(mill_picture(*program, *load_control("mach3"), "</title><script>", Lang::en));
  EXPECT_TRUE(svg.starts_with("<"));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

}  // namespace
}  // namespace kadr::milling_test
