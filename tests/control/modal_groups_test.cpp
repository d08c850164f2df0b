// control/linuxcnc/modal_groups: the groups of controls/linuxcnc.toml have
// the numbers of spec/linuxcnc 3; a user's file may define groups of its own.

#include "control/linuxcnc/modal_groups.h"

#include <gtest/gtest.h>

#include "config/control/control_file.h"

namespace kadr::modal_groups_test {
namespace {

using linuxcnc::ModalGroups;

TEST(modal_groups, have_the_numbers_of_their_names) {
  const ControlDef def = load_control("linuxcnc").value();
  const ModalGroups groups(def);
  for (const auto& [code, number] : std::vector<std::pair<std::int32_t, std::size_t>>{{10, 1}, {170, 2}, {930, 5}, {540, 12}, {921, 16}}) {
    const CodeRow& row = def.codes[static_cast<std::size_t>(def.row_of('G', code))];
    EXPECT_EQ(groups.number(row.group), number) << row.code;
    EXPECT_EQ(groups.index_of_g(number), row.group) << row.code;
  }
  const CodeRow& spindle = def.codes[static_cast<std::size_t>(def.row_of('M', 30))];
  EXPECT_EQ(groups.number(spindle.group), 7U);
  EXPECT_NE(groups.index_of_g(7), spindle.group);  // the group of G40
}

/// Regression: a group number greater than the last one became an index outside the table of a block's codes.
TEST(modal_groups, of_other_names_are_0) {
  ControlDef def;
  for (const char* name : {"", "12", "99", "M11", "-1", "shop", "5x", "", "M7"}) def.groups.push_back({name, false, -1, {}});
  const ModalGroups groups(def);
  for (std::size_t i = 0; i < def.groups.size(); ++i) EXPECT_EQ(groups.number(i), i == 1 ? 12U : i == 8 ? 7U : 0U) << i;
  EXPECT_EQ(groups.index_of_g(12), 1U);
  EXPECT_EQ(groups.index_of_g(5), 0U);
  EXPECT_EQ(groups.index_of_g(7), 0U);
}

}  // namespace
}  // namespace kadr::modal_groups_test
