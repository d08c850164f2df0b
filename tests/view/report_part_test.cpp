// The part in a report: its points are near the remaining surface, each with its tool and line.

#include "view/report/report_part.h"

#include <gtest/gtest.h>

#include <cstring>

#include "view/opening.h"

namespace kadr::report_part_test {
namespace {

TEST(ReportPart, IsWhatIsLeft) {
  OpeningRequest request;
  request.path = "report_part_test.ngc";
  request.control = "linuxcnc";
  request.text = "G21 G90 F600 S900 M3\nT1 M6\nG0 X-20 Y0 Z5\nG0 Z-3\nG1 X20\nG0 Z5\nM2\n";
  const auto opened = open_for_page(request);
  ASSERT_TRUE(opened) << opened.error();
  PartRequest blank;
  blank.stock = "box:-10,-10,-10,10,10,0";
  blank.resolution = 0.5;
  ToolGeometry mill;
  mill.number = 1, mill.diameter = 8, mill.flutes = 20, mill.length = 40;
  blank.tools.tools.push_back(mill);
  const auto run = PartRun::make(*opened, blank, {});
  ASSERT_TRUE(run) << run.error();
  const auto done = (*run)->execute();
  ASSERT_TRUE(done) << done.error();
  ReportPart part;
  take_part(**run, part, {});
  std::uint32_t head[4] = {};
  std::memcpy(head, part.frame.data(), sizeof head);
  EXPECT_EQ(head[0], 3U);
  const std::size_t points = head[2], triangles = head[3];
  ASSERT_GT(points, 8U);
  EXPECT_LT(triangles, 500U);  // a flat wall needs only a few triangles; the exact surface has thousands
  EXPECT_EQ(part.frame.size(), 16 + 20 * points + 12 * triangles);
  EXPECT_LE(part.off, 0.1 * part.cell + 1e-9);
  bool slot = false;
  for (std::size_t i = 0; i < points; ++i) {
    std::uint16_t tool = 0;
    std::uint32_t line = 0;
    float z = 0;
    std::memcpy(&z, part.frame.data() + 16 + 12 * i + 8, sizeof z);
    std::memcpy(&tool, part.frame.data() + 16 + 12 * points + 12 * triangles + 4 * i, sizeof tool);
    std::memcpy(&line, part.frame.data() + 16 + 16 * points + 12 * triangles + 4 * i, sizeof line);
    EXPECT_TRUE(tool == 1 || tool == 65535) << tool;
    EXPECT_EQ(tool == 65535, line == 0);
    slot = slot || (line == 5 && std::abs(double(z) + 3) < 0.1);
  }
  EXPECT_TRUE(slot);
  EXPECT_NE(part.result.find("\"left\""), std::string::npos);
}

}  // namespace
}  // namespace kadr::report_part_test
