// motion/look_ahead/speed_rules: reads the limits of a set-up; whatever the set-up does not contain is off. NCT 6, 7.

#include "motion/look_ahead/speed_rules.h"

#include <gtest/gtest.h>

namespace kadr::speed_rules_test {
namespace {

using Json = std::string_view;
const std::vector<std::string> names = {"X", "Y", "C"};

SpeedRules rules_of(Json json) {
  const auto setup = parse_setup(json);
  EXPECT_TRUE(setup.has_value());
  SpeedRules rules = speed_rules(*setup, names);
  obey_parameters(rules, *setup, names);
  return rules;
}

TEST(speed_rules, nothing_said_nothing_in_force) {
  const SpeedRules rules = rules_of("{}");
  EXPECT_FALSE(rules.in_force);
  EXPECT_FALSE(rules.slows_inner_arcs);
  EXPECT_FALSE(rules_of(R"({"parameters":{"N0306#0":1,"N0307":20,"N0310":900,"N0421":3,"N0422":50,"N1407":5,"N1410":0.5}})").in_force);
}

TEST(speed_rules, accelerations_by_axis_or_for_all) {
  const SpeedRules rules =
      rules_of(R"({"machine":{"*":{"acceleration":500,"jerk_time":0.1},"X":{"acceleration":1000},"C":{"acceleration":null}}})");
  EXPECT_TRUE(rules.in_force);
  EXPECT_TRUE(rules.accelerates());
  EXPECT_EQ(rules.stated, 7U);
  EXPECT_EQ(rules.acceleration[0], 1000);
  EXPECT_EQ(rules.acceleration[1], 500);
  EXPECT_EQ(rules.acceleration[2], unlimited);
  EXPECT_EQ(rules.build_up[0], 0.1);
  EXPECT_EQ(rules_of(R"({"machine":{"X":{"acceleration":1000}}})").stated, 1U);
}

TEST(speed_rules, accelerations_of_a_machine_whose_speed_the_control_makes) {
  MachineProfile profile;
  profile.axes["X"] = {10000, -1e300, 1e300, 400, 8000};
  const auto setup = parse_setup(R"({"machine":{"C":{"acceleration":90,"jerk_time":0.2},"Y":{"acceleration":null}}})");
  EXPECT_EQ(speed_rules(*setup, names, profile).stated, 6U);
  profile.planner = PlannerMode::control;
  const SpeedRules rules = speed_rules(*setup, names, profile);
  EXPECT_EQ(rules.stated, 7U);
  EXPECT_EQ(rules.acceleration[0], 400);
  EXPECT_EQ(rules.build_up[0], 400.0 / 8000);
  EXPECT_EQ(rules.acceleration[1], unlimited);
  EXPECT_EQ(rules.acceleration[2], 90);
  EXPECT_EQ(rules.build_up[2], 0.2);
  profile.planner = PlannerMode::optimal;
  EXPECT_EQ(speed_rules(*setup, names, profile).stated, 6U);
}

TEST(speed_rules, without_limit_the_rules_hold_but_nothing_accelerates) {
  const SpeedRules rules = rules_of(R"({"machine":{"*":{"acceleration":null}}})");
  EXPECT_TRUE(rules.in_force);
  EXPECT_FALSE(rules.accelerates());
}

TEST(speed_rules, parameters_by_name_number_or_for_all_axes) {
  const SpeedRules rules =
      rules_of(R"({"parameters":{"N0309":600,"N0309.2":300,"N0402.C":10,"N0305":0,"N0421#ROL":1,"N0422":25,"N1410":0}})");
  EXPECT_EQ(rules.axis_change[0], 10);
  EXPECT_EQ(rules.axis_change[1], 5);
  EXPECT_EQ(rules.normal[0], unlimited);
  EXPECT_EQ(rules.normal[2], 10);
  EXPECT_EQ(rules.max_feed[0], unlimited);
  EXPECT_TRUE(rules.overlaps_rapids);
  EXPECT_EQ(rules.overlap_from, 0.25);
  EXPECT_EQ(rules.inner_part, 1);
}

}  // namespace
}  // namespace kadr::speed_rules_test
