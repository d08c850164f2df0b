// Contours: reads the same rectangle with a hole in each of the three formats. Garbage ends in an alarm that names its line.

#include "config/drawing/drawing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

namespace kadr::contour_test {
namespace {

DrawingFault fault_of(std::string_view text) {
  const auto read = read_drawing(text);
  return read ? DrawingFault() : read.error();
}

TEST(Contour, Text) {
  const auto edges = read_drawing("# plate\nfrom 0 0\nline 100 0 open\narc 100 60 100 30 ccw\nline 0 60\nclose\ncircle 50 30 10\n");
  ASSERT_TRUE(edges);
  ASSERT_EQ(edges->size(), 6U);
  EXPECT_TRUE((*edges)[0].open);
  EXPECT_DOUBLE_EQ((*edges)[1].bulge, 1);
  EXPECT_EQ((*edges)[3].to, (Vec2{0, 0}));
  EXPECT_EQ((*edges)[4].line, 7U);
}

TEST(Contour, ArcsLongerThanHalfACircleAreTwoEdges) {
  const auto edges = read_drawing("from 10 0\narc 0 -10 0 0 ccw\n");
  ASSERT_TRUE(edges);
  ASSERT_EQ(edges->size(), 2U);
  EXPECT_NEAR((*edges)[0].bulge, std::tan(270.0 / 8 * rad_per_deg), 1e-12);
  EXPECT_NEAR((*edges)[0].to.x, -std::sqrt(50), 1e-12);
}

TEST(Contour, TextFaults) {
  EXPECT_EQ(fault_of("").alarm.id, AlarmId::contour_empty);
  EXPECT_EQ(fault_of("line 1 2\n").alarm.id, AlarmId::contour_word_missing);
  EXPECT_EQ(fault_of("from 0 0\nline 1\n").line, 2U);
  EXPECT_EQ(fault_of("from 0 0\nline 1 x\n").alarm.where, (Span{7, 8}));
  EXPECT_EQ(fault_of("from 0 0\nwander 1 2\n").alarm.id, AlarmId::contour_syntax);
  EXPECT_EQ(fault_of("from 0 0\narc 10 0 4 0 cw\n").alarm.id, AlarmId::contour_radius);
  EXPECT_EQ(fault_of("from 0 0\nline 1e9 0\n").alarm.id, AlarmId::contour_reach);
  EXPECT_EQ(fault_of("from 0 0\nline nan 0\n").alarm.id, AlarmId::contour_reach);
}

std::string dxf(const std::string& entities, const std::string& header = "") {
  return "0\nSECTION\n2\nHEADER\n" + header + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

TEST(Contour, DxfLinesArcsPolylines) {
  const auto edges = read_drawing(
      dxf("0\nLINE\n8\nOpen side\n10\n0\n20\n0\n11\n10\n21\n0\n"
          "0\nARC\n8\n0\n10\n10\n20\n5\n40\n5\n50\n270\n51\n90\n"
          "0\nLWPOLYLINE\n8\n0\n90\n3\n70\n1\n10\n20\n20\n0\n42\n1\n10\n30\n20\n0\n10\n30\n20\n9\n"
          "0\nPOLYLINE\n8\n0\n70\n0\n0\nVERTEX\n10\n1\n20\n1\n0\nVERTEX\n10\n2\n20\n1\n42\n-0.5\n0\nVERTEX\n10\n3\n20\n1\n0\nSEQEND\n"));
  ASSERT_TRUE(edges);
  ASSERT_EQ(edges->size(), 7U);
  EXPECT_TRUE((*edges)[0].open);
  EXPECT_NEAR((*edges)[1].bulge, 1, 1e-12);
  EXPECT_NEAR((*edges)[1].to.y, 10, 1e-12);
  EXPECT_EQ((*edges)[2].bulge, 1);
  EXPECT_EQ((*edges)[4].to, (Vec2{20, 0}));
  EXPECT_EQ((*edges)[6].bulge, -0.5);
}

TEST(Contour, DxfUnits) {
  const auto inch = read_drawing(dxf("0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n", "9\n$INSUNITS\n70\n1\n"));
  ASSERT_TRUE(inch);
  EXPECT_DOUBLE_EQ((*inch)[0].to.x, 25.4);
  EXPECT_EQ(fault_of(dxf("", "9\n$INSUNITS\n70\n17\n")).alarm.id, AlarmId::contour_unit);
}

TEST(Contour, DxfFaults) {
  EXPECT_EQ(fault_of(dxf("0\nLINE\n10\nabc\n20\n0\n")).alarm.id, AlarmId::contour_syntax);
  EXPECT_EQ(fault_of(dxf("0\nCIRCLE\n10\n0\n20\n0\n40\ninf\n")).alarm.id, AlarmId::contour_reach);
  EXPECT_EQ(fault_of("0\nSECTION\nwrong\n").alarm.id, AlarmId::contour_syntax);
}

TEST(Contour, SvgShapesInMillimetresFromTheLowerLeft) {
  const auto edges = read_drawing(
      "<svg width='100mm' height='50mm' viewBox='0 0 200 100'><g id='open-1'><path d='M0 100h20'/></g>"
      "<rect x='20' y='20' width='40' height='20' transform='translate(2,0)'/><circle cx='100' cy='50' r='10'/></svg>");
  ASSERT_TRUE(edges);
  ASSERT_EQ(edges->size(), 7U);
  EXPECT_EQ((*edges)[0].from, (Vec2{0, 0}));
  EXPECT_EQ((*edges)[0].to, (Vec2{10, 0}));
  EXPECT_TRUE((*edges)[0].open);
  EXPECT_EQ((*edges)[1].from, (Vec2{11, 40}));
  EXPECT_NEAR(std::abs((*edges)[5].bulge), 1, 1e-12);
}

TEST(Contour, SvgArcsStayArcsAndCurvesAreWithinTolerance) {
  const auto arc = read_drawing("<svg><path d='M0 0A10 10 0 0 1 20 0'/></svg>");
  ASSERT_TRUE(arc);
  ASSERT_EQ(arc->size(), 1U);
  EXPECT_NEAR(std::abs(arc->front().bulge), 1, 1e-9);
  const auto curve = read_drawing("<svg><path d='M0 0C0 20 40 20 40 0Q50 -10 60 0T80 0'/></svg>");
  ASSERT_TRUE(curve);
  EXPECT_GT(curve->size(), 10U);
  EXPECT_LT(curve->size(), 100U);
  for (std::size_t i = 1; i < curve->size(); ++i) EXPECT_EQ((*curve)[i].from, (*curve)[i - 1].to);
}

TEST(Contour, SvgFaults) {
  EXPECT_EQ(fault_of("<svg>\n<path d='M0 0 L'/>\n</svg>").line, 2U);
  EXPECT_EQ(fault_of("<svg><path").alarm.id, AlarmId::contour_syntax);
  EXPECT_EQ(fault_of("<html/>").alarm.id, AlarmId::contour_syntax);
  EXPECT_EQ(fault_of("<svg width='3 apples'/>").alarm.id, AlarmId::contour_unit);
  EXPECT_EQ(fault_of("<svg/>").alarm.id, AlarmId::contour_empty);
}

RC_GTEST_PROP(ContourProperty, GarbageEndsInAnAlarmOrInFiniteEdges, (const std::string& garbage)) {
  for (const char* const head : {"", "<svg><path d='", "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n", "from 0 0\n"}) {
    const auto edges = read_drawing(head + garbage);
    if (!edges) continue;
    for (const Edge& e : *edges) RC_ASSERT(std::isfinite(e.from.x + e.from.y + e.to.x + e.to.y) && std::abs(e.bulge) < 1.001);
  }
}

}  // namespace
}  // namespace kadr::contour_test
