// config/function_needs, control_loader_functions, control_loader_rules: what a row may require of the engine. The messages themselves
// are tested by tests/own_control.py.

#include <gtest/gtest.h>

#include "config/control/control_file.h"
#include "config/control/function.h"
#include "config/tools/toml_tools.h"

namespace kadr::control_rules_test {
namespace {

std::string refusal(const std::string& base, const std::string& rest) {
  const auto def = parse_control("extends = \"" + base + "\"\nid = \"own\"\n" + rest, "own.toml");
  return def ? std::string() : def.error();
}

TEST(needs, stand_in_the_table_of_functions) {
  EXPECT_EQ(traits_of(Function::rapid).needs, Needs::nothing);
  EXPECT_EQ(traits_of(Function::plane_rotation_on).needs, Needs::nct);
  EXPECT_EQ(traits_of(Function::plane_xy).needs, Needs::no_nct);
  EXPECT_EQ(traits_of(Function::pocket_run).needs, Needs::correctors);
  EXPECT_EQ(traits_of(Function::call_word).needs, Needs::sections);
  EXPECT_EQ(traits_of(Function::call_subprogram).needs, Needs::labels);
  EXPECT_EQ(traits_of(Function::feed_word).by, CalledBy::word);
  EXPECT_EQ(traits_of(Function::rapid).by, CalledBy::code);
}

/// Adds a row of its own for each function to each base. It must be accepted only where everything that the function needs exists.
TEST(needs, are_asked_for_by_the_loader) {
  std::string phases;
  for (std::size_t p = 0; p < static_cast<std::size_t>(Phase::none); ++p)
    phases += "\"" + std::string(name_of(static_cast<Phase>(p))) + "\", ";
  for (std::size_t i = 0; i < static_cast<std::size_t>(Function::count); ++i) {
    const auto f = static_cast<Function>(i);
    const std::string name(traits_of(f).name);
    const std::string row = "[order]\nphases = [" + phases + "]\n[g]\n\"300\" = { does = \"" + name + "\", takes = \"XYZ\" }\n";
    for (const std::string base : {"gost", "s2c42", "mach3", "correctors", "nct"}) {
      const std::string refused = refusal(base, row);
      const bool is_nct = base == "nct";
      const bool wrong = traits_of(f).by == CalledBy::word || (traits_of(f).needs == Needs::nct && !is_nct) ||
                         (traits_of(f).needs == Needs::no_nct && is_nct) ||
                         (traits_of(f).needs == Needs::correctors && base != "correctors") ||
                         (traits_of(f).needs == Needs::sections && base != "s2c42") ||
                         (traits_of(f).needs == Needs::labels && base != "mach3" && base != "nct" && base != "gost");
      if (!wrong) continue;  // it may be refused for another reason, or accepted
      EXPECT_EQ(refused.find("own.toml:6: G300: '" + name + "'"), 0U) << base << ": " << refused;
    }
  }
}

TEST(nearest, is_the_name_that_was_meant) {
  const std::vector<std::string_view> keys = {"takes", "needs", "needs_axis", "does", "group"};
  EXPECT_EQ(toml_tools::nearest("take", keys), "takes");
  EXPECT_EQ(toml_tools::nearest("tekes", keys), "takes");
  EXPECT_EQ(toml_tools::nearest("need_axis", keys), "needs_axis");
  EXPECT_EQ(toml_tools::nearest("gruop", keys), "");  // two letters of five
  EXPECT_EQ(toml_tools::nearest("colour", keys), "");
  EXPECT_EQ(toml_tools::nearest("", keys), "");
  EXPECT_EQ(toml_tools::nearest(std::string(10'000, 'x'), keys), "");
}

TEST(built_in_controls, keep_the_rules) {
  for (const std::string& id : built_in_controls()) EXPECT_EQ(refusal(id, ""), "");
}

}  // namespace
}  // namespace kadr::control_rules_test
