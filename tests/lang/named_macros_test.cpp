// lang/named/named_macros: names that stand for texts (spec/sinumerik 6.1).

#include "lang/named/named_macros.h"

#include <gtest/gtest.h>

namespace kadr {
namespace {

const NamedMacros macros{{"HOME", "G0 X0"}, {"AGAIN", "HOME"}, {"SELF", "SELF"}};

TEST(named_macros, replace_whole_names_in_any_case) {
  EXPECT_EQ(with_macros("home M5", macros), "G0 X0 M5");
  EXPECT_EQ(with_macros("HOMES", macros), std::nullopt);
  EXPECT_EQ(with_macros("MYHOME", macros), std::nullopt);
}

TEST(named_macros, leave_texts_and_system_variables) {
  EXPECT_EQ(with_macros("MSG(\"HOME\")", macros), std::nullopt);
  EXPECT_EQ(with_macros("R1=$HOME", macros), std::nullopt);
}

TEST(named_macros, may_stand_in_each_other_and_end) {
  EXPECT_EQ(with_macros("AGAIN", macros), "G0 X0");
  EXPECT_EQ(with_macros("SELF", macros), "SELF");
}

}  // namespace
}  // namespace kadr
