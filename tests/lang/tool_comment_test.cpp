// lang/text/tool_comment: what comments say of tools, as shops and CAM systems write them.

#include "lang/text/tool_comment.h"

#include <gtest/gtest.h>

namespace kadr::tool_comment_test {
namespace {

constexpr double none = -1;

TEST(tool_comment, as_written_in_programs) {
  const struct {
    const char* text;
    double tool, diameter, corner;
  } rows[] = {
      {"T1 D8 ENDMILL", 1, 8, none},
      {"ФРЕЗА 8", none, 8, none},
      {"Фреза ф8", none, 8, none},
      {"T01 FREZA D=10 R0.5", 1, 10, 0.5},
      {"T1 D=8. CR=0. - ZMIN=-5. - FLAT END MILL", 1, 8, 0},
      {"T12 D=6,5 R=0,5", 12, 6.5, 0.5},
      {"TOOL 3: 12 MM ENDMILL", 3, 12, none},
      {"10mm flat endmill", none, 10, none},
      {"СВЕРЛО Ø8.5", none, 8.5, none},
      {"сверло 8,5 мм", none, 8.5, none},
      {"T3 МЕТЧИК М8", 3, 8, none},
      {"ИНСТРУМЕНТ 4 ФРЕЗА ДИАМ. 16", 4, 16, none},
      {"T5 BALL R3", 5, 6, 3},
      {"T2 H2 D2", 2, none, none},  // numbers of offsets
      {"T2 H2 D2 12MM DRILL", 2, 12, none},
      {"DEPTH 12", none, none, none},
      {"PART 8", none, none, none},
      {"", none, none, none},
      {"T", none, none, none},
  };
  for (const auto& row : rows) {
    const ToolComment said = read_tool_comment(row.text, false);
    EXPECT_EQ(said.tool ? double(*said.tool) : none, row.tool) << row.text;
    EXPECT_EQ(said.diameter.value_or(none), row.diameter) << row.text;
    EXPECT_EQ(said.corner.value_or(none), row.corner) << row.text;
  }
}

TEST(tool_comment, kind_and_angle) {
  const struct {
    const char* text;
    ToolWord kind;
    double angle;
  } rows[] = {
      {"T1 D8 ENDMILL", ToolWord::mill, none},
      {"T1 D=8. CR=0. - ZMIN=-5. - FLAT END MILL", ToolWord::mill, none},
      {"6MM BALL END MILL", ToolWord::ball, none},
      {"Т5 фреза шаровая ф6", ToolWord::ball, none},
      {"T3 D=12. CR=0. TAPER=45DEG - ZMIN=-2. - CHAMFER MILL", ToolWord::chamfer, 90},
      {"T4 D=8.5 CR=0. TAPER=118DEG - DRILL", ToolWord::drill, 118},
      {"ЗЕНКОВКА D12 90°", ToolWord::chamfer, 90},
      {"СВЕРЛО 8,5", ToolWord::drill, none},
      {"T3 МЕТЧИК М8", ToolWord::tap, none},
      {"T9 D10 H7 REAMER", ToolWord::reamer, none},
      {"TURNED 45 DEG", ToolWord::none, 45},
      {"T2", ToolWord::none, none},
  };
  for (const auto& row : rows) {
    const ToolComment said = read_tool_comment(row.text, false);
    EXPECT_EQ(said.kind, row.kind) << row.text;
    EXPECT_EQ(said.angle.value_or(none), row.angle) << row.text;
  }
}

TEST(tool_comment, inches) {
  EXPECT_DOUBLE_EQ(read_tool_comment("T1 D0.5 ENDMILL", true).diameter.value_or(0), 12.7);
  EXPECT_DOUBLE_EQ(read_tool_comment("T1 D8 MM ENDMILL", true).diameter.value_or(0), 8);
  EXPECT_DOUBLE_EQ(read_tool_comment(".5 IN ENDMILL R.0625", true).diameter.value_or(0), 12.7);
  EXPECT_DOUBLE_EQ(read_tool_comment(".25\" DRILL, T4 D=.25 IN", false).diameter.value_or(0), 6.35);
}

TEST(tool_comment, of_a_line) {
  EXPECT_EQ(comments_of("N1 (a) G0 (b c) X1"), (std::vector<std::string>{"a", "b c"}));
  EXPECT_EQ(comments_of("N1 (a ; G0) X1 ; (rest"), (std::vector<std::string>{"a ; G0", " (rest"}));
  EXPECT_EQ(comments_of("N1 (open"), (std::vector<std::string>{"open"}));
  EXPECT_TRUE(comments_of("N1 G0 X1").empty());
  EXPECT_EQ(without_comments(" N1 (a) G0 ; x"), "N1  G0");
  EXPECT_EQ(without_comments("(only)"), "");
  EXPECT_EQ(without_comments("(open"), "");
}

}  // namespace
}  // namespace kadr::tool_comment_test
