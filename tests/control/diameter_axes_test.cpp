// [axes] diameter of a control file (docs/own-control.md): a word of such an axis is twice the distance travelled.

#include <gtest/gtest.h>

#include "run_program.h"

namespace kadr::diameter_axes_test {
namespace {

using namespace test;

tl::expected<ControlDef, std::string> own(const std::string& keys) {
  return parse_control("extends = \"gost\"\nid = \"own\"\n[axes]\n" + keys, "own.toml");
}

TEST(diameter_axes, are_named_by_the_control_file) {
  const auto def = own("diameter = [\"X\", \"Z\"]\n");
  ASSERT_TRUE(def) << def.error();
  EXPECT_EQ(def->diameter, 0b101U);
  EXPECT_EQ(control("gost").diameter, 0U);
}

TEST(diameter_axes, go_half_of_what_is_written) {
  const auto def = own("diameter = [\"X\"]\n");
  ASSERT_TRUE(def) << def.error();
  Control machine(*def, {}, Program{"test", text_source("% LF\nN1 G17 G90 G94 LF\nN2 G00 X20. Y20. LF\nN3 M02 LF\n"), {}},
                  RunLimits{100, 10});
  ActionBatch batch;
  std::vector<Motion> motions;
  for (Control::State state = machine.run(batch);; state = machine.run(batch)) {
    ASSERT_NE(state, Control::State::stopped) << name_of(machine.report().alarm.id);
    for (const Action& action : batch)
      if (const auto* motion = std::get_if<Motion>(&action.what)) motions.push_back(*motion);
    if (state == Control::State::ended) break;
  }
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_EQ(motions[0].to[0], 10);
  EXPECT_EQ(motions[0].to[1], 20);
}

TEST(diameter_axes, that_are_no_axes_or_no_list_are_refused) {
  EXPECT_EQ(own("diameter = [\"Q\"]\n").error(), "own.toml:4: diameter: no such axis");
  EXPECT_NE(own("diameter = \"X\"\n").error().find("own.toml:4: diameter"), std::string::npos);
}

}  // namespace
}  // namespace kadr::diameter_axes_test
