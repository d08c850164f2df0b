// config/setup: the state before the start; keys of tests/golden/README.md.

#include "config/setup.h"

#include <gtest/gtest.h>

namespace kadr {
namespace {

Setup read(std::string_view json) {
  auto setup = parse_setup(json);
  EXPECT_TRUE(setup) << setup.error();
  return setup.value_or(Setup{});
}

std::string refusal(std::string_view json) {
  const auto setup = parse_setup(json);
  EXPECT_FALSE(setup) << json;
  return setup ? "" : setup.error();
}

TEST(setup, empty_is_power_on) {
  const kadr::Setup setup = read("{}");
  EXPECT_TRUE(setup.axes.empty());
  EXPECT_EQ(setup.spindle().dir, "stop");
  EXPECT_EQ(setup.feed_override, 100);
}

TEST(setup, every_served_key) {
  const kadr::Setup s = read(R"({"axes": ["X", "Z"], "start": {"X": 1.5}, "start_frame": "work", "modal": ["G90"], "feed": 120,
    "work_offsets": {"G54": {"X": 1, "G17": 0}}, "zeros": {"1": {"X": 100}}, "correctors": {"17": 2.5}, "variables": {"#1": 2, "#2": null},
    "spindle": {"1": {"rpm": 600, "dir": "cw"}}, "tool": 4, "skip": [1, 2], "optional_stop": true, "mirror": ["X"],
    "override": {"feed": 50}, "reference_points": {"2": {"Z": 0}}, "probe": {"1": {"X": 80}, "2": null}, "points": [0.5], "watch": ["#100"]})");
  EXPECT_EQ(s.start.at("X"), 1.5);
  EXPECT_TRUE(s.start_in_work);
  EXPECT_EQ(s.work_offsets.at("G54").count("G17"), 0U);
  EXPECT_EQ(s.zeros.at(1).at("X"), 100);
  EXPECT_EQ(s.correctors.at(17), 2.5);
  EXPECT_EQ(s.variables.at("#2"), std::nullopt);
  EXPECT_EQ(s.spindle().rpm, 600);
  EXPECT_EQ(s.spindle().dir, "cw");
  EXPECT_EQ(s.feed_override, 50);
  EXPECT_EQ(s.rapid_override, 100);
  EXPECT_EQ(s.probe.at(1)->at("X"), 80);
  EXPECT_EQ(s.probe.at(2), std::nullopt);
  EXPECT_EQ(s.skip, (std::vector<int>{1, 2}));
}

TEST(setup, offsets_are_geometry_and_wear) {
  const kadr::Setup s = read(R"({"offsets": {"1": {"length": 100, "length_wear": -0.5, "radius": 5, "radius_wear": 0.25}}})");
  EXPECT_EQ(s.offsets.at(1).whole_length(), 99.5);
  EXPECT_EQ(s.offsets.at(1).whole_radius(), 5.25);
}

TEST(setup, probe_workpiece) {
  const kadr::Setup s =
      read(R"({"probe_workpiece": {"tip_radius": 2, "hole": {"center": {"X": 50.3, "Y": 24.6}, "diameter": 40, "top": 0, "depth": 30}}})");
  ASSERT_TRUE(s.probe_hole);
  EXPECT_EQ(s.probe_hole->center_y, 24.6);
  EXPECT_EQ(s.probe_hole->depth, 30);
}

TEST(setup, keys_not_served_may_say_nothing) {
  read(
      R"({"single_block": false, "clock": null, "channel": 1, "tool_table": {}, "events": [], "parameters": {}, "plane": "", "diameter": {"X": false}})");
  read(R"({"machine": {"*": {"rapid": 5000, "acceleration": null, "jerk_time": 0}}})");
  EXPECT_EQ(refusal(R"({"events": [{"do": "start"}]})"), "setup key 'events' is not served by this control yet");
  EXPECT_EQ(refusal(R"({"channel": 2})"), "setup key 'channel' is not served by this control yet");
  EXPECT_EQ(refusal(R"({"machine": {"X": {"acceleration": 500}}})"),
            "setup key 'machine.X.acceleration' is not served by this control yet");
  EXPECT_EQ(refusal(R"({"work_offsets": {"G54": {"G17": 30}}})"), "setup key 'work_offsets.G54.G17' is not served by this control yet");
}

TEST(setup, unknown_key_names_the_nearest) {
  EXPECT_EQ(refusal(R"({"ofsets": {}})"), "unknown setup key 'ofsets'; the nearest known one is 'offsets'");
  EXPECT_EQ(refusal(R"({"override": {"fed": 10}})"), "unknown setup key 'override.fed'; the nearest known one is 'feed'");
}

TEST(setup, wrong_forms) {
  EXPECT_EQ(refusal(R"({"start": {"X": "1"}})"), "setup key 'start.X' must be a number");
  EXPECT_EQ(refusal(R"({"zeros": {"a": {}}})"), "setup key 'zeros.a' must be named by a whole number");
  EXPECT_EQ(refusal(R"({"points": [2]})"), "setup key 'points' must be a list of parts, 0 to 1");
  EXPECT_EQ(refusal(R"([])"), "setup key 'setup' must be a table { … }");
  EXPECT_NE(refusal("{").find("not JSON"), std::string::npos);
  EXPECT_FALSE(load_setup("/nowhere/setup.json"));
}

}  // namespace
}  // namespace kadr
