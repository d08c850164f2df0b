// control/nct/tools/tools: data input between G10 L75, L76 or L77 and G11. NCT 12.4.

#include <gtest/gtest.h>

#include "control/nct/tools/tools.h"

namespace kadr::nct::data_input_test {
namespace {

using Tables = kadr::Setup;  // in a test, Setup would mean GoogleTest's Setup

constexpr std::uint32_t uencv = 1, sencv = 17, sdlcv = 29;  // 12.3.1

/// Rows 2 and 9, as in 12.5.
Tables drills() {
  Tables setup;
  setup.tool_table[2].type = setup.tool_table[9].type = 81501070;
  setup.tool_table[2].info = setup.tool_table[9].info = sencv;
  setup.tool_table[2].h = 12, setup.tool_table[2].warn = 7, setup.tool_table[2].s = 100;
  setup.tool_table[9].life = 180;
  return setup;
}

/// A line such as "N2 T81501070": words and values, separated by blanks.
struct Line {
  explicit Line(const std::string& text) : source(text) {
    for (std::size_t at = 0; at < source.size();) {
      const std::size_t end = std::min(source.find(' ', at), source.size());
      const std::string_view digits = std::string_view(source).substr(at + 1, end - at - 1);
      words.push_back(
          {source[at], std::stod(std::string(digits)), digits, {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)}});
      at = end + 1;
    }
  }
  DataBlock block() const { return {words, {0, static_cast<std::uint32_t>(source.size())}}; }
  std::string source;
  std::vector<DataWord> words;
};

Status feed(ToolManagement& tools, DataKind kind, std::initializer_list<const char*> lines) {
  DataInput input;
  input.begin(kind);
  for (const char* line : lines) KADR_TRY(input.block(Line(line).block(), tools));
  return {};
}

TEST(data_input, kinds) {
  EXPECT_EQ(data_kind(75, 1), DataKind::register_rows);
  EXPECT_EQ(data_kind(75, 2), DataKind::modify_rows);
  EXPECT_EQ(data_kind(75, 3), DataKind::delete_rows);
  EXPECT_EQ(data_kind(76, 1), DataKind::places);
  EXPECT_EQ(data_kind(77, 6), DataKind::forms);
  EXPECT_EQ(data_kind(76, 2), std::nullopt);
}

TEST(data_input, registers_a_cleared_row) {  // golden 12-15
  ToolManagement tools(drills());
  const Status done = feed(tools, DataKind::register_rows,
                           {"N2", "T81501070 Q10001 B1 C0 L200 H12 D23 F0.25", "P0 R10011", "P3 R-1.5", "", "N4", "T7 J3 K4 I9 A20"});
  ASSERT_TRUE(done);
  const ToolRow& row = *tools.row(2);
  EXPECT_EQ(row.type, 81501070);
  EXPECT_EQ(row.info, sencv);
  EXPECT_EQ(row.status, 1U);
  EXPECT_EQ(row.life, 200);
  EXPECT_EQ(row.h, 12);
  EXPECT_EQ(row.d, 23);
  EXPECT_EQ(row.f, 0.25);
  EXPECT_EQ(row.s, 0);
  EXPECT_EQ(row.warn, 0);
  EXPECT_EQ(row.user_bits, 19U);
  EXPECT_EQ(row.user[2], -1.5);
  EXPECT_EQ(tools.row(4)->g, 3);
  EXPECT_EQ(tools.row(4)->w, 4);
  EXPECT_EQ(tools.row(4)->warn, 9);
  EXPECT_EQ(tools.row(4)->form, 20U);
}

TEST(data_input, modifies_only_what_is_given) {
  ToolManagement tools(drills());
  ASSERT_TRUE(feed(tools, DataKind::modify_rows, {"N2", "C150", "N9", "Q1"}));
  EXPECT_EQ(tools.row(2)->counter, 150);
  EXPECT_EQ(tools.row(2)->h, 12);
  EXPECT_EQ(tools.row(9)->info, uencv);
  EXPECT_EQ(tools.row(9)->life, 180);
}

TEST(data_input, deletes_rows) {
  ToolManagement tools(drills());
  ASSERT_TRUE(feed(tools, DataKind::delete_rows, {"N2", "N7"}));
  EXPECT_EQ(tools.row(2), nullptr);
  EXPECT_NE(tools.row(9), nullptr);
}

TEST(data_input, fills_the_place_table) {  // golden 12-17
  Tables setup;
  setup.place_table = {{{1, 8}, 0}, {{1, 4}, 0}, {{10, 1}, 5}};
  ToolManagement tools(setup);
  ASSERT_TRUE(feed(tools, DataKind::places, {"N1 P4 R9", "N1 P8 R2", "N10 R0", "N11 P77 R3"}));
  EXPECT_EQ(tools.places(), (PocketTable{{{1, 4}, 9}, {{1, 8}, 2}, {{10, 1}, 0}, {{11, 1}, 3}}));
}

TEST(data_input, fills_the_form_table) {  // golden 12-18
  ToolManagement tools;
  ASSERT_TRUE(feed(tools, DataKind::forms, {"N5 P4 Q1 R0 S0 T0", "N6 P3 T1"}));
  EXPECT_EQ(tools.forms().at(5).left, 4);
  EXPECT_EQ(tools.forms().at(5).right, 1);
  EXPECT_EQ(tools.forms().at(6).left, 3);
  EXPECT_EQ(tools.forms().at(6).geometry, 1);
}

TEST(data_input, binary_digits_of_an_expression) {
  ToolManagement tools;
  DataInput input;
  input.begin(DataKind::register_rows);
  ASSERT_TRUE(input.block(Line("N1").block(), tools));
  const DataWord q[] = {{'Q', 11101, "", {}}};
  ASSERT_TRUE(input.block({q, {}}, tools));
  EXPECT_EQ(tools.row(1)->info, sdlcv);
}

struct Wrong {
  DataKind kind;
  std::vector<const char*> lines;
  AlarmId id;
  char letter;
};

TEST(data_input, alarms) {
  using enum DataKind;
  const Wrong all[] = {
      {register_rows, {"T5"}, AlarmId::word_missing, 'N'},
      {register_rows, {"N1 T5"}, AlarmId::data_block, 'T'},
      {register_rows, {"N0"}, AlarmId::value_out_of_range, 'N'},
      {register_rows, {"N51"}, AlarmId::value_out_of_range, 'N'},
      {register_rows, {"N1.5"}, AlarmId::value_out_of_range, 'N'},
      {register_rows, {"N1", "T100000000"}, AlarmId::value_out_of_range, 'T'},
      {register_rows, {"N1", "T-1"}, AlarmId::value_out_of_range, 'T'},
      {register_rows, {"N1", "Q12"}, AlarmId::value_out_of_range, 'Q'},
      {register_rows, {"N1", "Q100001"}, AlarmId::value_out_of_range, 'Q'},
      {register_rows, {"N1", "A21"}, AlarmId::value_out_of_range, 'A'},
      {register_rows, {"N1", "B5"}, AlarmId::value_out_of_range, 'B'},
      {register_rows, {"N1", "H100"}, AlarmId::value_out_of_range, 'H'},
      {register_rows, {"N1", "K100"}, AlarmId::value_out_of_range, 'K'},
      {register_rows, {"N1", "T5 T6"}, AlarmId::data_block, 'T'},
      {register_rows, {"N1", "T5 X6"}, AlarmId::data_block, 'X'},
      {register_rows, {"N1", "P1 T6"}, AlarmId::data_block, 'T'},
      {register_rows, {"N1", "P1"}, AlarmId::word_missing, 'R'},
      {register_rows, {"N1", "R1"}, AlarmId::word_missing, 'P'},
      {register_rows, {"N1", "P4 R1"}, AlarmId::value_out_of_range, 'P'},
      {register_rows, {"N1", "P0 R100000000"}, AlarmId::value_out_of_range, 'R'},
      {delete_rows, {"N1", "T5"}, AlarmId::data_block, 'T'},
      {places, {"N5 P1 R1"}, AlarmId::value_out_of_range, 'N'},
      {places, {"N12 R1"}, AlarmId::value_out_of_range, 'N'},
      {places, {"N1 R1"}, AlarmId::word_missing, 'P'},
      {places, {"N1 P1"}, AlarmId::word_missing, 'R'},
      {places, {"P1 R1"}, AlarmId::word_missing, 'N'},
      {places, {"N1 P1 R51"}, AlarmId::value_out_of_range, 'R'},
      {forms, {"N21 P1"}, AlarmId::value_out_of_range, 'N'},
      {forms, {"N0 P1"}, AlarmId::value_out_of_range, 'N'},
      {forms, {"N1 T2"}, AlarmId::value_out_of_range, 'T'},
      {forms, {"N1 P1.5"}, AlarmId::value_out_of_range, 'P'},
      {forms, {"P1"}, AlarmId::word_missing, 'N'},
  };
  for (const Wrong& wrong : all) {
    ToolManagement tools({}, {50, 3, 99});
    DataInput input;
    input.begin(wrong.kind);
    Status status;
    for (const char* line : wrong.lines) status = input.block(Line(line).block(), tools);
    ASSERT_EQ(status ? no_alarm : status.error().id, wrong.id) << wrong.lines.back();
    EXPECT_EQ(status.error().args[0].text(), std::string(1, wrong.letter)) << wrong.lines.back();
    EXPECT_FALSE(tools.enabled()) << wrong.lines.back();  // nothing has changed
  }
}

}  // namespace
}  // namespace kadr::nct::data_input_test
