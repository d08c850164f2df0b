// lang/text/box_comment: the rectangular blank that comments of milling programs state. The rows without "made" are from public programs,
// or in the form that the named CAM system writes.

#include "lang/text/box_comment.h"

#include <gtest/gtest.h>

namespace kadr::box_comment_test {
namespace {

struct Row {
  const char* text;
  bool inch;
  double x, y, z;  // 0: no size
};

constexpr Row rows[] = {
    {"INFO. // WORKPICE SIZE 500X500X10 /// PROCESSING: OPERATION DRILL AND TIP ...  RESULT: 5BLOCK OF 4HOLE ", false, 500, 500, 10},
    {"INFO. // WORKPICE SIZE 50X25X5 MATERIAL:ALUMINIUM", false, 50, 25, 5},
    {"FINISH STEPS ON 2X2X1 BLOCK", true, 50.8, 50.8, 25.4},
    {"STOCK/BLOCK,100,80,20,0,0,20", false, 100, 80, 20},  // CutViewer
    {"Stock/Block, 4.0, 3.5, .75", true, 101.6, 88.9, 19.05},
    {"PLATE 120X80X25", false, 120, 80, 25},  // from here on made
    {"ЗАГОТОВКА 120Х80Х25", false, 120, 80, 25},
    {"Заготовка 120х80х25 мм", false, 120, 80, 25},
    {"ПЛИТА 300*200*16", false, 300, 200, 16},
    {"ЗАГОТОВКА: ДЛИНА 120 ШИРИНА 80 ВЫСОТА 25", false, 120, 80, 25},
    {"STOCK: 4\" X 3\" X 1/2\"", true, 101.6, 76.2, 12.7},
    {"STOCK SIZE 4. X 3. X 1-1/4", true, 101.6, 76.2, 31.75},
    {"BLANK 120 x 80 x 25 mm", true, 120, 80, 25},
    {"MATERIAL AL 6061 SIZE X=120.0 Y=80.0 Z=25.0", false, 120, 80, 25},
    {"STOCK X100. Y50. Z20.", false, 100, 50, 20},
    {"STOCK L120 W80 H25", false, 120, 80, 25},
    {"BILLET 6.0 LONG 4.0 WIDE 1.5 THICK", true, 152.4, 101.6, 38.1},
    {"ROHTEIL 80×60×20", false, 80, 60, 20},
    {"MATERIAL: STEEL 45, 120X80X25", false, 120, 80, 25},
    // not about a blank, or not its size
    {"CLAMP PLATE 100X50X10", false, 0, 0, 0},
    {"POCKET 40X30X5 IN PLATE", false, 0, 0, 0},
    {"PLATE 120X80", false, 0, 0, 0},
    {"STOCK X-50 Y-40 Z-10", false, 0, 0, 0},
    {"STOCK X0 X100 Y0 Y50 Z0 Z20", false, 0, 0, 0},
    {"T1 1/2 FLAT ENDMILL|H0|XY STOCK TO LEAVE - .005|Z STOCK TO LEAVE - .0", true, 0, 0, 0},
    {"NIST_MTC_CRADA_PLATE-20", true, 0, 0, 0},
    {"120X80X25", false, 0, 0, 0},
    {"SHEET 1X2X3X4", false, 0, 0, 0},
    {"STOCK 0X80X25", false, 0, 0, 0},
    {"DATE 12/3/24 BLOCK", false, 0, 0, 0},
    {"", false, 0, 0, 0},
};

TEST(BoxComment, ReadsTheSizesOfBlanks) {
  for (const Row& row : rows) {
    const auto read = read_box_comment(row.text, row.inch);
    if (row.x == 0) {
      EXPECT_FALSE(read.has_value()) << row.text;
      continue;
    }
    ASSERT_TRUE(read.has_value()) << row.text;
    EXPECT_NEAR(read->size[0], row.x, 1e-9) << row.text;
    EXPECT_NEAR(read->size[1], row.y, 1e-9) << row.text;
    EXPECT_NEAR(read->size[2], row.z, 1e-9) << row.text;
  }
}

TEST(BoxComment, KnowsWhichSizeLiesAlongWhichAxis) {
  EXPECT_TRUE(read_box_comment("STOCK X=20 Y=80 Z=120", false)->has_axes);
  EXPECT_FALSE(read_box_comment("STOCK 20X80X120", false)->has_axes);
  const auto zero = read_box_comment("STOCK/BLOCK,100,80,20,50,40,20", false)->zero;
  ASSERT_TRUE(zero.has_value());
  EXPECT_EQ((*zero)[0], 50);
  EXPECT_EQ((*zero)[2], 20);
}

TEST(BoxComment, AHeadingMayPrecedeTheSizes) {
  EXPECT_TRUE(is_heading_of_box("Material Size"));
  EXPECT_TRUE(is_heading_of_box("ЗАГОТОВКА"));
  EXPECT_FALSE(is_heading_of_box("Material Size 5"));
  EXPECT_FALSE(is_heading_of_box("X= 120.000, Y= 80.000, Z= 25.000"));
}

}  // namespace
}  // namespace kadr::box_comment_test
