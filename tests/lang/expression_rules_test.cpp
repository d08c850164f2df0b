// lang/expression/expression_rules: finds the row of an operator, and the function with which a text begins.

#include "lang/expression/expression_rules.h"

#include "choices.h"

namespace kadr::expression_rules_test {
namespace {

using namespace test;

std::string found(const ExpressionRows& rows, std::string_view text) {
  const ExpressionRow* const row = rows.find(text);
  return row == nullptr ? "" : row->text;
}

TEST(expression_rows, the_longer_text_is_meant) {
  ExpressionRows rows;
  for (const char* const text : {"*", "**", "SIN", "SINH", "S"}) rows.add({.text = text});
  EXPECT_EQ(found(rows, "**2"), "**");
  EXPECT_EQ(found(rows, "*2"), "*");
  EXPECT_EQ(found(rows, "sinh[1]"), "SINH");
  EXPECT_EQ(found(rows, "Sin[1]"), "SIN");
  EXPECT_EQ(found(rows, "sqrt"), "S");
  EXPECT_EQ(found(rows, "/"), "");
  EXPECT_EQ(found(rows, ""), "");
  EXPECT_EQ(found(rows, "\xD0\xA1"), "");
}

/// Compares find with a search through all rows.
RC_GTEST_PROP(expression_rows, find_is_the_longest_of_all_that_fit, ()) {
  Choices choose = choices(80);
  constexpr const char* texts[] = {"A", "AB", "ABC", "B", "BA", "*", "**", "***", "<", "<=", "AND", "ANDA"};
  ExpressionRows rows;
  for (const char* const text : texts)
    if (choose.one_in(2)) rows.add({.text = text});
  std::string written;
  for (int i = choose.between(0, 6); i > 0; --i) written += choose.of("AaBbNnDd*<=C1 ");
  std::string longest;
  for (const ExpressionRow& row : rows.all()) {
    std::string capitals = written.substr(0, row.text.size());
    for (char& c : capitals) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (capitals == row.text && row.text.size() > longest.size()) longest = row.text;
  }
  RC_ASSERT(found(rows, written) == longest);
}

TEST(operations, have_names_by_their_operands) {
  EXPECT_EQ(operation_named("add", 2), Op::add);
  EXPECT_FALSE(operation_named("add", 1));
  EXPECT_EQ(operation_named("sine", 1), Op::sine);
  EXPECT_FALSE(operation_named("variable", 1));
  for (const int operands : {1, 2}) {
    std::size_t count = 0;
    for (std::string_view name = operation_name(0, operands); !name.empty(); name = operation_name(++count, operands))
      EXPECT_TRUE(operation_named(name, operands)) << name;
    EXPECT_GT(count, 10U);
  }
}

}  // namespace
}  // namespace kadr::expression_rules_test
