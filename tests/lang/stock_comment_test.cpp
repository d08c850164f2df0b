// lang/text/stock_comment: the blank that comments of lathe programs state. The rows without "made" are from public programs.

#include "lang/text/stock_comment.h"

#include <gtest/gtest.h>

namespace kadr::stock_comment_test {
namespace {

constexpr double none = -1;

struct Row {
  const char* text;
  bool inch;
  double diameter, bore, length;
};

constexpr Row rows[] = {
    {"MATL: 2.75\" OD STEEL TUBING 1.73 L", true, 69.85, none, 43.942},
    {"MATERIAL: A36 STEEL TUBING - 4.5OD X 2.75 ID X .53L", true, 114.3, 69.85, 13.462},
    {"MATERIAL: 4\"OD X 2\"ID X.85\"L 1026 TUBING", true, 101.6, 50.8, 21.59},
    {"MATERIAL: 5-1/2\" ALUMINUM BARSTOCK", true, 139.7, none, none},
    {"MATERIAL: 5\" 6061 ALUMINUM BARSTOCK 1.3\"L", true, 127, none, 33.02},
    {"8\" ALUMINUM SOLID STOCK", true, 203.2, none, none},
    {"MATL: 5\" OD STEEL TUBING", true, 127, none, none},
    {"MATL: 3\"OD 2\"ID STEEL TUBING", true, 76.2, 50.8, none},
    {"Stock Diameter = 1.0625", true, 26.9875, none, none},
    {"BILLET X50.8 Z70", false, 50.8, none, 70},
    {"BILLET X47.63  Z80", false, 47.63, none, 80},
    {"STOCK DIA 10.00  FINISH ALLOW 0.25  UNMARKED CHAMFER C0.3", false, 10, none, none},
    {"STOCK DIA 50 LENGTH 80", false, 50, none, 80},  // from here on made
    {"BLANK D50 L80", false, 50, none, 80},
    {"STOCK: D=50.5 L=80", false, 50.5, none, 80},
    {"STOCK 50 X 80", false, 50, none, 80},
    {"SHAFT, BAR 50 MM", false, 50, none, none},
    {"SHAFT WITH THREAD M24X2, BAR D60, 95 MM OUT OF THE CHUCK", false, 60, none, none},
    {"RAW Ø40 x 120", false, 40, none, none},
    {"BAR 2\"", false, 50.8, none, none},
    {"ЗАГОТОВКА D60 L120", false, 60, none, 120},
    {"Пруток Ф45", false, 45, none, none},
    {"BLANK OD 60 ID 25 LENGTH 40", false, 60, 25, 40},
    {"BUSHING 50 X 32, BORE D25, BAR D55, 50 MM OUT OF THE CHUCK", false, 55, none, none},
    {"HUB, SIX HOLES D8 ON D60 BY LIVE TOOL, BLANK D80 L40", false, 80, none, 40},
    {"PIN WITH A TAPER AND A THREAD M16X2: STOCK DIA 30 LENGTH 95", false, 30, none, 95},
    {"TUBE OD 40 ID 40", false, none, none, none},
    // not about a blank
    {"STOCK 100 X 50 X 20", false, none, none, none},
    {"T08: 1\" BORING BAR CNMG 432", true, none, none, none},
    {"T06 - 1\" BORING BAR", true, none, none, none},
    {"FACE STOCK/OD TURN", true, none, none, none},
    {"START AT STOCK OD", true, none, none, none},
    {"Z0: -.025 FROM FACE OF STOCK", true, none, none, none},
    {"MATERIAL LENGTH FROM JAW FACE: 2\"", true, none, none, none},
    {"JAW PRESSURE - 5 BAR", true, none, none, none},
    {"MATERIAL: LASER CUT FLANGES, STEEL", true, none, none, none},
    {"MATERIAL 1045", false, none, none, none},
    {"BROCA DIA. 10MM", false, none, none, none},
    {"BAR STOP 50", false, none, none, none},
};

void expect(std::optional<double> read, double wanted, const char* what, const char* text) {
  EXPECT_EQ(read.has_value(), wanted != none) << what << " of " << text;
  if (!read || wanted == none) return;
  EXPECT_NEAR(*read, wanted, 1e-6) << what << " of " << text;
}

TEST(StockComment, AsShopsWriteThem) {
  for (const Row& row : rows) {
    const StockComment read = read_stock_comment(row.text, row.inch);
    expect(read.diameter, row.diameter, "diameter", row.text);
    expect(read.bore, row.bore, "bore", row.text);
    expect(read.length, row.length, "length", row.text);
  }
}

TEST(StockComment, TheLineOfASimulator) {
  EXPECT_EQ(billet_of("[BILLET X50 Z70"), "BILLET X50 Z70");
  EXPECT_EQ(billet_of(" [billet x50 z70"), "billet x50 z70");
  EXPECT_EQ(billet_of("[TOOLDEF T1"), "");
  EXPECT_EQ(billet_of("(BILLET X50)"), "");
  EXPECT_EQ(billet_of(""), "");
}

}  // namespace
}  // namespace kadr::stock_comment_test
