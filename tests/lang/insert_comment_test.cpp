// lang/text/insert_comment: the turning tools that comments describe. The rows without "made" are from public programs.

#include "lang/text/insert_comment.h"

#include <gtest/gtest.h>

namespace kadr::insert_comment_test {
namespace {

constexpr double none = -1;
using W = InsertWork;

struct Row {
  const char* text;
  bool inch;
  W work;
  bool inside;
  double angle, corner, edge, width;
};

constexpr Row rows[] = {
    {"T1212 OD TURN CNMG 432 CR:.032 IC908", true, W::turning, false, 80, 0.8128, 12.8956, none},
    {"T12: OD TURN: CNMG 432 IC907 .032\" NR", true, W::turning, false, 80, 0.8128, 12.8956, none},
    {"T12 OD TURN CNMG 431", true, W::turning, false, 80, 0.396875, 12.8956, none},
    {"T0202 5/8 CARB BORING BAR, CCGT 3-2-AS IC20", true, W::boring, true, 80, 0.79375, 9.6717, none},
    {"T10 3/4 BB CCGT 3-1-AS", true, W::boring, true, 80, 0.396875, 9.6717, none},
    {"T08 ID TURN 3/4\" SHANK BORING BAR CCGT-AS/AF CR:.016", true, W::boring, true, 80, 0.4064, none, none},
    {"T12 - OD TURN .032 NR", true, W::turning, false, none, 0.8128, none, none},
    {"T06 - OD PART OFF BLADE .079 W", true, W::grooving, false, none, none, none, 2.0066},
    {"T0808 GRIP 3003Y .125\" WD OD GROOVE TURN", true, W::grooving, false, none, none, none, 3.175},
    {"T10: OD GROOVING GRIP 318-040Y IC808 .125\" WIDE .016\" NR", true, W::grooving, false, none, 0.4064, none, 3.175},
    {"T10: OD GROOVE TURN GRIP 4002Y IC808 .008\" NR", true, W::grooving, false, none, 0.2032, none, 4},
    {"T10 .157\" GROOVE TURNING TOOL", true, W::grooving, false, none, none, none, 3.9878},
    {"T10 OD THREAD PENTA HOLDER,", true, W::threading, false, 60, none, none, none},
    {"VNMG160404", false, W::turning, false, 35, 0.4, 16, none},  // from here on made
    {"T0303 DNMG 15 06 08 FINISH", false, W::turning, false, 55, 0.8, 15, none},
    {"WNMG 080408", false, W::turning, false, 80, 0.8, 8, none},
    {"RCMT 1204M0", false, W::turning, false, 0, 6, 12, none},
    {"T0101 CNMG 80 DEG, NOSE 0.8: TURNING", false, W::turning, false, 80, 0.8, none, none},
    {"РЕЗЕЦ ПРОХОДНОЙ", false, W::turning, false, none, none, none, none},
    {"РЕЗЕЦ РАСТОЧНОЙ CCMT09T304", false, W::boring, true, 80, 0.4, 9, none},
    {"РЕЗЕЦ КАНАВОЧНЫЙ 3 ММ", false, W::grooving, false, none, none, none, 3},
    {"T5 РЕЗЕЦ ОТРЕЗНОЙ B=3", false, W::grooving, false, none, none, none, 3},
    {"РЕЗЕЦ РЕЗЬБОВОЙ 16ER", false, W::threading, false, 60, none, none, none},
    {"GROOVING TOOL 4 MM", false, W::grooving, false, none, none, none, 4},
    {"T0303 GROOVE 3.0 R0.2", false, W::grooving, false, none, 0.2, none, 3},
    // no turning tool
    {"OD TURN", true, W::none, false, none, none, none, none},
    {"FACE STOCK/OD TURN", true, W::none, false, none, none, none, none},
    {"MATERIAL: 5-1/2\" ALUMINUM BARSTOCK", true, W::none, false, none, none, none, none},
    {"T3 DRILL 8.5", false, W::none, false, none, none, none, none},
    {"T1 D8 ENDMILL", false, W::none, false, none, none, none, none},
    {"JAW PRESSURE - 5 BAR", true, W::none, false, none, none, none, none},
    {"", false, W::none, false, none, none, none, none},
};

void expect(const std::optional<double>& read, double wanted, const char* what, const char* text) {
  EXPECT_EQ(read.has_value(), wanted != none) << what << ": " << text;
  if (read && wanted != none) {
    EXPECT_NEAR(*read, wanted, 1e-3) << what << ": " << text;
  }
}

TEST(InsertComment, ReadsTurningTools) {
  for (const Row& row : rows) {
    const InsertComment read = read_insert_comment(row.text, row.inch);
    EXPECT_EQ(read.work, row.work) << row.text;
    if (read.work == W::none) continue;
    EXPECT_EQ(read.inside, row.inside) << row.text;
    expect(read.angle, row.angle, "angle", row.text);
    expect(read.corner, row.corner, "corner", row.text);
    expect(read.edge, row.edge, "edge", row.text);
    expect(read.width, row.width, "width", row.text);
  }
}

}  // namespace
}  // namespace kadr::insert_comment_test
