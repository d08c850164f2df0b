// control/macro_b/output/print: how DPRNT, BPRNT and messages print variables,
// compared with printf and with whole-number arithmetic. NCT 23.2.13.

#include "control/macro_b/output/print.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "choices.h"

namespace kadr::macro_b::print_test {
namespace {

using test::Choices;
using test::choices;
using Values = std::vector<std::optional<double>>;

constexpr auto spaces = PrintFill::spaces;
constexpr auto none = PrintFill::none;

/// Reads `#` and digits, and records what it has read.
struct Reader {
  std::vector<std::string> read;
  Result<std::size_t> operator()(std::string_view rest) {
    std::size_t size = 1;
    while (size < rest.size() && rest[size] >= '0' && rest[size] <= '9') ++size;
    if (size == 1) return fail(alarm(AlarmId::expression_syntax, {}));
    read.emplace_back(rest.substr(0, size));
    return size;
  }
};

Result<PrintText> parsed(std::string_view text, PrintKind kind = PrintKind::decimal) {
  Reader reader;
  return parse_print(text, kind, std::ref(reader));
}

std::string sent(std::string_view text, const Values& values, PrintFill fill) { return decimal(parsed(text)->pieces, values, fill); }

std::string hex(std::string_view text, const Values& values) {
  const Result<std::string> bytes = binary(parsed(text, PrintKind::binary)->pieces, values);
  if (!bytes) return std::string(name_of(bytes.error().id));
  std::string shown;
  for (const char c : *bytes) {
    char pair[3];
    std::snprintf(pair, sizeof pair, "%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
    shown += pair;
  }
  return shown;
}

TEST(decimal, the_manuals_example) {  // golden 23-94, and PNT=0
  const char* text = "[X#130[53]Y#500[53]T#10[20]]";
  const Values values = {35.897421, -150.8, 14.8};
  EXPECT_EQ(sent(text, values, spaces), "X    35.897Y-  150.800T 15\r\n");
  EXPECT_EQ(sent(text, values, none), "X35.897Y-150.800T15\r\n");
}

TEST(decimal, text_alone_and_stars) {
  EXPECT_EQ(sent("[B]", {}, spaces), "B\r\n");
  EXPECT_EQ(sent("[C*/X+-9 *a]", {}, spaces), "C /X+-9 A\r\n");
  EXPECT_EQ(sent("[]", {}, spaces), "\r\n");
}

struct Case {
  std::optional<double> value;
  int before, after;
  const char* with_spaces;
  const char* without;
};

TEST(decimal_number, cases) {
  const Case all[] = {
      {0.723415, 5, 3, "     0.723", "0.723"},
      {-0.5, 2, 1, "- 0.5", "-0.5"},
      {std::nullopt, 5, 3, "     0.000", "0.000"},
      {std::nullopt, 4, 0, "    0", "0"},
      {4567.0, 4, 0, " 4567", "4567"},
      {-0.0004, 3, 3, "   0.000", "0.000"},  // no minus sign before a value that rounds to zero
      {-0.0, 1, 0, " 0", "0"},
      {0.25, 0, 2, " .25", ".25"},
      {5.25, 0, 2, " 5.25", "5.25"},
      {12345.678, 2, 1, " 12345.7", "12345.7"},  // wider than its columns: printed whole
      {99.96, 2, 1, " 100.0", "100.0"},
      {0.5, 1, 0, " 1", "1"},  // halves round away from zero
      {-2.5, 1, 0, "-3", "-3"},
      {0.125, 1, 2, " 0.13", "0.13"},
      {1.005, 1, 2, " 1.00", "1.00"},  // the double is below 1.005
      {1e300, 1, 0, nullptr, nullptr},
      {std::numeric_limits<double>::denorm_min(), 1, 9, " 0.000000000", "0.000000000"},
  };
  for (const Case& c : all) {
    if (c.with_spaces == nullptr) {
      EXPECT_EQ(decimal_number(c.value, c.before, c.after, none).size(), 301U);
      continue;
    }
    EXPECT_EQ(decimal_number(c.value, c.before, c.after, spaces), c.with_spaces);
    EXPECT_EQ(decimal_number(c.value, c.before, c.after, none), c.without);
  }
}

/// The reference for values n/256, computed in whole numbers.
std::string slow_number(long n, int after) {
  long long scale = 1;
  for (int i = 0; i < after; ++i) scale *= 10;
  const long long scaled = std::llabs(n) * scale;  // divided by 256 below
  const long long rounded = scaled / 256 + (scaled % 256 >= 128 ? 1 : 0);
  std::string text = std::to_string(rounded / scale);
  if (after > 0) {
    const std::string decimals = std::to_string(rounded % scale);
    text += '.' + std::string(static_cast<std::size_t>(after) - decimals.size(), '0') + decimals;
  }
  return n < 0 && rounded != 0 ? '-' + text : text;
}

RC_GTEST_PROP(decimal_number, agrees_with_whole_numbers_ties_included, ()) {
  Choices choose = choices(10);
  const int n = choose.between(-2'000'000, 2'000'000);
  const int after = choose.between(0, 9);
  RC_ASSERT(decimal_number(n / 256.0, 1, after, none) == slow_number(n, after));
}

RC_GTEST_PROP(decimal_number, agrees_with_printf, (double any)) {
  Choices choose = choices(20);
  const double value = choose.one_in(2) ? any : choose.between(-99'999'999, 99'999'999) / std::pow(10, choose.between(0, 8));
  const int after = choose.between(0, 14);
  char buffer[1500];
  std::snprintf(buffer, sizeof buffer, "%.1100f", value);  // the exact decimal value
  const std::string rest = std::string(buffer).substr(std::string(buffer).find('.') + 1 + static_cast<std::size_t>(after));
  RC_PRE(rest[0] != '5' || rest.find_first_not_of('0', 1) != std::string::npos);  // printf rounds ties to even
  std::snprintf(buffer, sizeof buffer, "%.*f", after, value);
  std::string expected = buffer;
  if (expected.find_first_of("123456789") == std::string::npos && expected[0] == '-') expected.erase(0, 1);
  RC_ASSERT(decimal_number(value, 1, after, none) == expected);
}

RC_GTEST_PROP(decimal_number, spaces_fill_the_field_and_change_nothing_else, ()) {
  Choices choose = choices(20);
  const double value = choose.between(-9'999'999, 9'999'999) / 1000.0;
  const int before = choose.between(1, 9);
  const int after = choose.between(0, 6);
  const std::string filled = decimal_number(value, before, after, spaces);
  std::string bare = filled;
  bare.erase(std::remove(bare.begin(), bare.end(), ' '), bare.end());
  RC_ASSERT(bare == decimal_number(value, before, after, none));
  const std::size_t width = static_cast<std::size_t>(1 + before + (after > 0 ? 1 + after : 0));
  if (std::fabs(value) < std::pow(10, before) - 1) RC_ASSERT(filled.size() == width);
  RC_ASSERT(filled[0] == ' ' || filled[0] == '-');
}

TEST(binary, the_manuals_examples) {  // golden 23-91, 23-92
  EXPECT_EQ(hex("[C*/X#110[3]Y#120[3]M#112[0]]", {318.49362, 0.723415, 23.9}), "43202F580004DC1E59000002D34D000000180D0A");
  EXPECT_EQ(hex("[#120[3]]", {258.647673}), "0003F2580D0A");
}

TEST(binary, empty_negative_and_too_large) {
  EXPECT_EQ(hex("[#1[3]]", {std::nullopt}), "000000000D0A");
  EXPECT_EQ(hex("[#1[0]]", {-1.5}), "FFFFFFFE0D0A");
  EXPECT_EQ(hex("[#1[0]]", {-0.4}), "000000000D0A");
  EXPECT_EQ(hex("[#1[0]]", {2147483647.0}), "7FFFFFFF0D0A");
  EXPECT_EQ(hex("[#1[0]]", {-2147483648.0}), "800000000D0A");
  EXPECT_EQ(hex("[#1[0]]", {2147483647.5}), "value_limit");
  EXPECT_EQ(hex("[#1[8]]", {100.0}), "value_limit");
  EXPECT_EQ(hex("[#1[0]]", {1e300}), "value_limit");
}

RC_GTEST_PROP(binary, agrees_with_whole_numbers, ()) {
  Choices choose = choices(10);
  const int n = choose.between(-20'000'000, 20'000'000);
  const int decimals = choose.between(0, 2);
  const auto bytes = binary({{"", 0, 0, static_cast<std::uint8_t>(decimals)}}, Values{n / 256.0});
  std::string digits = slow_number(n, decimals);
  digits.erase(std::remove(digits.begin(), digits.end(), '.'), digits.end());
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<unsigned char>((*bytes)[i]);
  RC_ASSERT(static_cast<std::int32_t>(word) == std::stol(digits));
  RC_ASSERT(bytes->substr(4) == "\r\n");
}

TEST(parse_print, pieces_slots_and_size) {
  Reader reader;
  const auto text = parse_print("[X #130 [53]Y#7[4]] (rest)", PrintKind::decimal, std::ref(reader));
  ASSERT_TRUE(text);
  const std::vector<PrintPiece> expected = {{"X", std::nullopt, 0, 0}, {"", 0, 5, 3}, {"Y", std::nullopt, 0, 0}, {"", 1, 4, 0}};
  EXPECT_EQ(text->pieces, expected);
  EXPECT_EQ(text->size, 19U);
  EXPECT_EQ(reader.read, (std::vector<std::string>{"#130", "#7"}));
}

struct Wrong {
  const char* text;
  PrintKind kind;
  AlarmId id;
  Span where;
};

TEST(parse_print, alarms) {
  using enum PrintKind;
  const Wrong all[] = {
      {"[X#1]", decimal, AlarmId::print_format, {2, 5}},         {"[X#1[]]", decimal, AlarmId::print_format, {2, 6}},
      {"[#1[00]]", decimal, AlarmId::print_format, {1, 7}},      {"[#1[0]]", decimal, AlarmId::print_format, {1, 6}},
      {"[#1[88]]", decimal, AlarmId::print_format, {1, 7}},      {"[#1[123]]", decimal, AlarmId::print_format, {1, 8}},
      {"[#1[5.3]]", decimal, AlarmId::print_format, {1, 8}},     {"[#1[9]]", binary, AlarmId::print_format, {1, 6}},
      {"[#1[53]]", binary, AlarmId::print_format, {1, 7}},       {"[A.B]", decimal, AlarmId::print_format, {2, 3}},
      {"[\xD0\x96]", decimal, AlarmId::print_format, {1, 3}},    {"[A(B)]", decimal, AlarmId::print_format, {2, 3}},
      {"[AB", decimal, AlarmId::bracket_not_closed, {0, 1}},     {"[#1[53]", decimal, AlarmId::bracket_not_closed, {0, 1}},
      {"[#A[53]]", decimal, AlarmId::expression_syntax, {0, 0}},
  };
  for (const Wrong& wrong : all) {
    const auto text = parsed(wrong.text, wrong.kind);
    ASSERT_FALSE(text) << wrong.text;
    EXPECT_EQ(text.error().id, wrong.id) << wrong.text;
    EXPECT_EQ(text.error().where, wrong.where) << wrong.text;
  }
}

TEST(parse_print, limits_of_digits) {
  EXPECT_EQ(sent("[#1[96]]", {1.5}, none), "1.500000\r\n");
  EXPECT_EQ(sent("[#1[09]]", {0.5}, none), ".500000000\r\n");
}

RC_GTEST_PROP(parse_print, takes_any_text, ()) {
  Choices choose = choices(60);
  std::string text = "[";
  const char all[] = "[]#123ABx*/+- .\\n\xD0\x96(";
  for (int i = choose.between(0, 30); i > 0; --i) text += all[choose.below(sizeof all - 1)];
  for (const PrintKind kind : {PrintKind::decimal, PrintKind::binary}) {
    const auto result = parsed(text, kind);
    if (result) RC_ASSERT(result->size <= text.size() && text[result->size - 1] == ']');
    else RC_ASSERT(result.error().where.end <= text.size());
  }
  Reader reader;
  const PrintText message = parse_message(text, std::ref(reader));
  for (const PrintPiece& piece : message.pieces) RC_ASSERT(!piece.slot || *piece.slot < reader.read.size());
}

TEST(parse_message, values_and_line_breaks) {  // 23.1.8
  Reader reader;
  const PrintText text = parse_message("D = #140[53] mm\\nhole #3 * [ok] #", std::ref(reader));
  EXPECT_EQ(reader.read, (std::vector<std::string>{"#140", "#3"}));
  EXPECT_EQ(joined(text.pieces, Values{12.5, 7.0}, none), "D = 12.500 mm\nhole #3 * [ok] #");
  EXPECT_EQ(joined(text.pieces, Values{12.5, 7.0}, spaces), "D =     12.500 mm\nhole #3 * [ok] #");
}

TEST(parse_message, text_stays_as_it_is) {
  Reader reader;
  const std::string text = "Деталь №3: \\проверить [53] #x[53]";
  EXPECT_EQ(joined(parse_message(text, std::ref(reader)).pieces, {}, spaces), text);
}

}  // namespace
}  // namespace kadr::macro_b::print_test
