// config/machine/machine_profile: machines/*.toml.

#include "config/machine/machine_profile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "own_place.h"

namespace kadr::machine_profile_test {
namespace {

std::string refusal(const std::string& toml) {
  const auto file = own_place("profile.toml");
  std::ofstream(file) << toml;
  const auto profile = load_machine(file.string());
  std::filesystem::remove(file);
  EXPECT_FALSE(profile);
  return profile ? "" : profile.error().substr(file.string().size());
}

TEST(machine_profile, built_in_ones_load) {
  for (const char* id : {"generic", "s2c42-mill", "mach3-router"}) {
    const auto profile = load_machine(id);
    ASSERT_TRUE(profile) << profile.error();
    EXPECT_EQ(profile->id, id);
    EXPECT_FALSE(profile->name_ru.empty());
    for (const char* axis : {"X", "Y", "Z"}) EXPECT_GT(profile->axes.at(axis).rapid, 0) << id;
  }
  EXPECT_EQ(load_machine("s2c42-mill")->axes.at("Z").least, -260);
}

TEST(machine_profile, lathes) {
  for (const char* id : {"lathe", "lathe-cy", "haas-st20"}) {
    const auto profile = load_machine(id);
    ASSERT_TRUE(profile) << profile.error();
    EXPECT_EQ(profile->id, id);
    EXPECT_EQ(profile->most_rpm, 4000) << id;
    EXPECT_EQ(profile->chains.tool.front(), "Z") << "the bed carries the saddle";
    EXPECT_EQ(profile->axes.contains("Y"), std::string(id) == "lathe-cy");
    EXPECT_EQ(profile->axes.contains("C"), std::string(id) == "lathe-cy");
  }
  const MachineProfile st20 = load_machine("haas-st20").value();  // the public data sheet
  EXPECT_EQ(st20.axes.at("X").most - st20.axes.at("X").least, 236);
  EXPECT_EQ(st20.axes.at("Z").most - st20.axes.at("Z").least, 572);
  EXPECT_EQ(st20.axes.at("X").rapid, 24000);
  EXPECT_EQ(st20.axes.at("Z").rapid, 24000);
  const MachineProfile with_y = load_machine("lathe-cy").value();
  EXPECT_EQ(with_y.chains.part, std::vector<std::string>{"C"}) << "the spindle carries the part";
  EXPECT_TRUE(with_y.axes.at("C").joint.rolls_over);
}

TEST(machine_profile, m_codes) {
  const MachineProfile with_y = load_machine("lathe-cy").value();
  EXPECT_EQ(with_y.m_codes.at(35).en, "C axis on");
  EXPECT_EQ(with_y.m_codes.at(35).ru, "ось C включена");
  const std::string axes = "id = \"x\"\n[axes]\nX = {}\n";
  for (const char* rows : {"m = 1", "[m]\nM68 = { en = \"a\" }", "[m]\n10000 = { en = \"a\" }", "[m]\n68 = \"a\"", "[m]\n68 = {}"})
    EXPECT_NE(refusal(rows == std::string("m = 1") ? "m = 1\n" + axes : axes + rows).find("[m] must have rows"), std::string::npos) << rows;
  EXPECT_NE(refusal(axes + "[m]\n68 = { de = \"a\" }").find("unknown key 'de'"), std::string::npos);
}

TEST(machine_profile, unknown_names_the_known) {
  EXPECT_EQ(load_machine("planer").error(),
            "no machine 'planer'; there are: generic, haas-st20, head-head, head-table, lathe-cy, lathe, linuxcnc-sim, mach3-router, "
            "nct-vmc, s2c42-mill, table-table, or a file of your own (NAME.toml)");
  EXPECT_EQ(load_machine("/nowhere.toml").error(), "/nowhere.toml: cannot be read: there is no such file");
}

TEST(machine_profile, mistakes_have_a_line) {
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nX = { rapd = 1 }"), ":3: unknown key 'rapd'");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nX = { limits = [2, 1] }"),
            ":3: limits must be [least, most], the second above the first, each a number, -10000000 to 10000000 mm or degrees");
  EXPECT_EQ(refusal("id = 'a'\ntool_change = -1\n[axes]"), ":2: tool_change must be a number, 0 to 86400 s");
  EXPECT_EQ(refusal("id = 'a'\nspindle_speed = -1\n[axes]"), ":2: spindle_speed must be a number, 0 to 1000000 rev/min");
  EXPECT_EQ(refusal("id = 'a'"), ": [axes] is missing");
  EXPECT_EQ(refusal("id = 'a'\nplanner = 'fast'\n[axes]"), ":2: 'planner' must be \"control\" or \"optimal\"");
  EXPECT_EQ(refusal("id = 'a'\nplanner = 1\n[axes]"), ":2: 'planner' must be \"control\" or \"optimal\"");
}

// A typing error must not become a motion that never ends.
TEST(machine_profile, numbers_beyond_every_machine) {
  for (const char* acceleration : {"0", "1e-300", "-500", "nan", "inf", "1e300", "'500'", "true"})
    EXPECT_EQ(refusal(std::string("id = 'a'\n[axes]\nX = { acceleration = ") + acceleration + " }"),
              ":3: acceleration must be a number, 0.001 to 1000000000 mm/s² or degrees/s²");
  for (const char* rapid : {"0", "-1", "nan", "1e-300"})
    EXPECT_EQ(refusal(std::string("id = 'a'\n[axes]\nX = { rapid = ") + rapid + " }"),
              ":3: rapid must be a number, 0.001 to 1000000000 mm/min or degrees/min");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nX = { jerk = 1e-9 }"), ":3: jerk must be a number, 0.001 to 1000000000000 mm/s³ or degrees/s³");
  for (const char* limits : {"[1, 1]", "[2, 1]", "[nan, 1]", "[-inf, inf]", "[1]", "1", "[1, 2, 3]", "['1', 2]"})
    EXPECT_EQ(refusal(std::string("id = 'a'\n[axes]\nX = { limits = ") + limits + " }"),
              ":3: limits must be [least, most], the second above the first, each a number, -10000000 to 10000000 mm or degrees");
  EXPECT_EQ(refusal("id = 'a'\ntolerance = -0.1\n[axes]"), ":2: tolerance must be a number, 0 to 10000000 mm");
}

TEST(machine_profile, the_programmed_speed_counts_if_nobody_says_whose) {
  EXPECT_EQ(load_machine("generic")->planner, PlannerMode::programmed);
  EXPECT_EQ(load_machine("nct-vmc")->planner, PlannerMode::control);
  const auto file = own_place("planner.toml");
  std::ofstream(file) << "id = 'a'\nplanner = 'optimal'\n[axes]";
  EXPECT_EQ(load_machine(file.string())->planner, PlannerMode::optimal);
  std::filesystem::remove(file);
}

TEST(machine_profile, chains_of_axes) {
  const MachineProfile machine = load_machine("table-table").value();
  EXPECT_EQ(machine.chains.tool, (std::vector<std::string>{"X", "Z"}));
  EXPECT_EQ(machine.chains.part, (std::vector<std::string>{"Y", "A", "C"}));
  const AxisJoint& a = machine.axes.at("A").joint;
  EXPECT_TRUE(a.turns);
  EXPECT_TRUE(a.reversed);
  EXPECT_EQ(a.direction, (Vec3{1, 0, 0}));
  EXPECT_EQ(a.through, (Vec3{-400, -250, -420}));
  EXPECT_EQ(machine.axes.at("X").joint.direction, (Vec3{1, 0, 0})) << "by its letter";
  EXPECT_FALSE(load_machine("generic")->chains.given());

  EXPECT_EQ(refusal("id = 'a'\n[axes]\nX = {}\n[kinematics]\ntool = ['X', 'Q']"), ":5: [axes] has no axis 'Q'");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nX = {}\n[kinematics]\ntool = ['X']\npart = ['X']"), ":6: axis X stands twice in [kinematics]");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nQ = {}\n[kinematics]\ntool = ['Q']"), ":5: axis Q: say 'along' or 'turns'");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nX = {}\n[kinematics]\ntool = 'X'"), ":5: tool must be a list of axes");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nX = {}\n[kinematics]\nhead = ['X']"), ":5: unknown key 'head'");
  EXPECT_EQ(refusal("id = 'a'\nkinematics = 1\n[axes]"), ":2: [kinematics] must be a table: tool = […], part = […]");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nA = { turns = [0, 0, 0] }"), ":3: turns must not be [0, 0, 0]");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nA = { turns = [0, 1] }"),
            ":3: turns must be three numbers, along X, Y and Z, each a number, -10000000 to 10000000 mm or degrees");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nA = { turns = [0, 1, 0], along = [1, 0, 0] }"), ":3: axis A has 'along' and 'turns': one of them");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nX = { through = [0, 1, 0] }"), ":3: 'through' belongs to a rotary axis");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nC = { reversed = 1 }"), ":3: reversed must be true or false");
  EXPECT_EQ(refusal("id = 'a'\n[axes]\nC = { roll_over = true, limits = [0, 1] }"), ":3: an axis that rolls over has no limits");
}

}  // namespace
}  // namespace kadr::machine_profile_test
