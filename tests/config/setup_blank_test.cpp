// config/setup/setup_blank: the blank that a set-up states.

#include "config/setup/setup_blank.h"

#include <gtest/gtest.h>

namespace kadr::setup_blank_test {
namespace {

TEST(SetupBlank, ReadsBlankAndFixtures) {
  const SetupBlank blank = setup_blank(R"({"stock": "box:0,0,0,1,1,1", "fixtures": ["box:1,0,0,2,1,1", 5], "skip": [1]})");
  EXPECT_EQ(blank.stock, "box:0,0,0,1,1,1");
  EXPECT_EQ(blank.fixtures, (std::vector<std::string>{"box:1,0,0,2,1,1"}));
}

TEST(SetupBlank, StatesNothing) {
  for (const char* const text : {"{}", R"({"stock": null})", R"({"stock": 5, "fixtures": "box"})", "[1]", "no JSON", ""}) {
    EXPECT_EQ(setup_blank(text).stock, "") << text;
    EXPECT_TRUE(setup_blank(text).fixtures.empty()) << text;
  }
}

}  // namespace
}  // namespace kadr::setup_blank_test
