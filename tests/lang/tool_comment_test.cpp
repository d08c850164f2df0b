// lang/text/tool_comment: what comments say about tools, as shops and CAM systems
// write them. The rules and most of the comments are in tests/lang/tool_comments.tsv.

#include "lang/text/tool_comment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace kadr::tool_comment_test {
namespace {

constexpr double none = -1;

constexpr double tolerance = 0.002;          // mm: the table has four decimals, and some of its sizes are in inches
constexpr std::size_t rows_of_table = 650;   // at least; an empty or missing table must not pass
constexpr std::size_t columns_of_table = 7;  // unit, text, tool, diameter, corner, kind, from

const char* name_of(ToolWord kind) {
  constexpr const char* names[] = {"none", "mill", "ball", "drill", "chamfer", "taper", "tap", "reamer"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<std::string> columns_of(const std::string& line) {
  std::vector<std::string> columns;
  std::istringstream in(line);
  for (std::string column; std::getline(in, column, '\t');) columns.push_back(column);
  return columns;
}

/// `*` accepts any reading, `-` requires that nothing is read.
testing::AssertionResult is_as_expected(const char* what, std::optional<double> read, const std::string& expected) {
  const bool same = expected == "*" || (expected == "-" ? !read : read && std::fabs(*read - std::stod(expected)) <= tolerance);
  if (same) return testing::AssertionSuccess();
  return testing::AssertionFailure() << what << " " << (read ? std::to_string(*read) : "-") << ", not " << expected;
}

void check_row(const std::vector<std::string>& row, const std::string& place) {
  const ToolComment tool_data = read_tool_comment(row[1], row[0] == "inch");
  const std::string of = place + " (" + row[1] + ")";
  EXPECT_TRUE(is_as_expected("tool", tool_data.tool ? std::optional<double>(*tool_data.tool) : std::nullopt, row[2])) << of;
  EXPECT_TRUE(is_as_expected("diameter", tool_data.diameter, row[3])) << of;
  EXPECT_TRUE(is_as_expected("corner", tool_data.corner, row[4])) << of;
  if (row[5] != "*") {
    EXPECT_EQ(name_of(tool_data.kind), row[5]) << of;
  }
  EXPECT_FALSE(tool_data.unsure && tool_data.diameter) << of;
}

TEST(tool_comment, as_the_table_has_it) {
  std::ifstream file(KADR_ROOT "/tests/lang/tool_comments.tsv");
  std::size_t number = 0, rows = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.empty() || line[0] == '#' || line.starts_with("unit\t")) continue;
    const std::vector<std::string> row = columns_of(line);
    ASSERT_EQ(row.size(), columns_of_table) << "row " << number;
    ASSERT_TRUE(row[0] == "mm" || row[0] == "inch") << "row " << number;
    check_row(row, "row " + std::to_string(number));
    ++rows;
  }
  EXPECT_GE(rows, rows_of_table);
}

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
      {"T7 D=10", 7, 10, none},
      {"T1 H1 D21", 1, none, none},
      {"T05 END MILL D16, CORRECTOR 21", 5, 16, none},
      {"СВЕРЛИТЬ 3 ОТВ. ПОД М8, СВЕРЛО Д6.8", none, 6.8, none},
      {"T3 DRILL 10", 3, 10, none},
      {"BROCA 6MM", none, 6, none},
      {"TOOL 3: 12 MM ENDMILL", 3, 12, none},
      {"10mm flat endmill", none, 10, none},
      {"СВЕРЛО Ø8.5", none, 8.5, none},
      {"сверло 8,5 мм", none, 8.5, none},
      {"T3 МЕТЧИК М8", 3, 8, none},
      {"ИНСТРУМЕНТ 4 ФРЕЗА ДИАМ. 16", 4, 16, none},
      {"T5 BALL R3", 5, 6, 3},
      {"T2 H2 D2", 2, none, none},  // the numbers are offset numbers
      {"T2 H2 D2 12MM DRILL", 2, 12, none},
      {"DEPTH 12", none, none, none},
      {"PART 8", none, none, none},
      {"", none, none, none},
      {"T", none, none, none},
  };
  for (const auto& row : rows) {
    const ToolComment tool_data = read_tool_comment(row.text, false);
    EXPECT_EQ(tool_data.tool ? double(*tool_data.tool) : none, row.tool) << row.text;
    EXPECT_EQ(tool_data.diameter.value_or(none), row.diameter) << row.text;
    EXPECT_EQ(tool_data.corner.value_or(none), row.corner) << row.text;
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
    const ToolComment tool_data = read_tool_comment(row.text, false);
    EXPECT_EQ(tool_data.kind, row.kind) << row.text;
    EXPECT_EQ(tool_data.angle.value_or(none), row.angle) << row.text;
  }
}

TEST(tool_comment, inches) {
  EXPECT_DOUBLE_EQ(read_tool_comment("T1 D0.5 ENDMILL", true).diameter.value_or(0), 12.7);
  EXPECT_DOUBLE_EQ(read_tool_comment("T1 D8 MM ENDMILL", true).diameter.value_or(0), 8);
  EXPECT_DOUBLE_EQ(read_tool_comment(".5 IN ENDMILL R.0625", true).diameter.value_or(0), 12.7);
  EXPECT_DOUBLE_EQ(read_tool_comment(".25\" DRILL, T4 D=.25 IN", false).diameter.value_or(0), 6.35);
}

TEST(tool_comment, of_several_tools_the_first) {
  const ToolComment tool_data = read_tool_comment("T1 = D16 ENDMILL, T3 = DRILL 6.8", false);
  EXPECT_EQ(tool_data.tool, 1U);
  EXPECT_EQ(tool_data.diameter, 16);
  EXPECT_EQ(tool_data.kind, ToolWord::mill);
}

// Readings that would look right and be wrong; other tables would not show them.
TEST(tool_comment, rather_nothing_than_a_wrong_size) {
  const struct {
    const char* text;
    bool inch;
  } rows[] = {
      {"3/8 OR 1/2 ENDMILL", true},
      {"SETUP 1/2 ENDMILL", true},  // the first of two tools
      {"1/4 TAP DRILL", true},      // the drill for a quarter-inch tap, not a quarter-inch drill
      {"DRILL AND TAP 1/4-20", true},
      {"8-32 TAP #29 DRILL", true},
      {"T3 TURN OD DIA 1.5", true},
      {"ENDMILL BROKE 1/2 WAY", true},
      {"MILL 3/8 DEEP", true},
      {"DRILL A HOLE", true},
      {"C DRILL", true},  // a centre drill
      {"T1 DIA 0.5000 ENDMILL", false},
      {"DRILL 10", false},  // perhaps the tenth drilling operation
      {"DRILL HOLES DIA 6", false},
      {"12MM PLATE 10MM ENDMILL", false},
      {"M29 S500 TAP", false},
      {"ENDMILL WEAR OFFSET D31", false},
      {"VERSION 2.5 ENDMILL PROGRAM", false},
  };
  for (const auto& row : rows) EXPECT_FALSE(read_tool_comment(row.text, row.inch).diameter) << row.text;
}

TEST(tool_comment, tells_where_it_is_not_sure) {
  for (const char* text : {"6. FLAT ENDMILL", "TOOL 1 = CHAMFER MILL .010", "T4 = SPOT DRILL", "1/2 ENDMILL OVERSIZE"}) {
    EXPECT_TRUE(read_tool_comment(text, true).unsure) << text;
    EXPECT_FALSE(read_tool_comment(text, true).diameter) << text;
  }
  for (const char* text : {"1/2 ENDMILL", "T12", "DEPTH .5", "CLAMP AT THE EDGES", ""})
    EXPECT_FALSE(read_tool_comment(text, true).unsure) << text;
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
