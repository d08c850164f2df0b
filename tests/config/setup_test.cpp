// config/setup/setup: the state before the start; the keys are those of tests/golden/README.md.

#include "config/setup/setup.h"

#include <gtest/gtest.h>

namespace kadr::setup_test {
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

TEST(setup, start_of_a_run) {
  const kadr::Setup s = read(R"({"axes": ["X", "Z"], "start": {"X": 1.5}, "start_frame": "work", "modal": ["G90"], "feed": 120,
    "zeros": {"1": {"X": 100}}, "correctors": {"17": 2.5}, "tool": 4, "skip": [1, 2], "optional_stop": true, "single_block": true,
    "mirror": ["X"], "override": {"feed": 50}, "reference_points": {"2": {"Z": 0}}, "probe": {"1": {"X": 80}, "8": null},
    "points": [0.5], "watch": ["#100"], "plane": "XC", "diameter": {"X": true, "Y": false}})");
  EXPECT_EQ(s.start.at("X"), 1.5);
  EXPECT_TRUE(s.start_in_work);
  EXPECT_EQ(s.zeros.at(1).at("X"), 100);
  EXPECT_EQ(s.correctors.at(17), 2.5);
  EXPECT_EQ(s.feed_override, 50);
  EXPECT_EQ(s.rapid_override, 100);
  EXPECT_EQ(s.probe.at(1)->at("X"), 80);
  EXPECT_EQ(s.probe.at(8), std::nullopt);
  EXPECT_EQ(s.skip, (std::vector<int>{1, 2}));
  EXPECT_TRUE(s.single_block);
  EXPECT_EQ(s.plane, "XC");
  EXPECT_EQ(s.diameter, (std::map<std::string, bool>{{"X", true}, {"Y", false}}));
}

TEST(setup, offsets) {
  const kadr::Setup s = read(R"({"offsets": {"1": {"length": 100, "length_wear": -0.5, "radius": 5, "radius_wear": 0.25,
    "corner_radius": 0.8, "corner_radius_wear": 0.1}}})");
  EXPECT_EQ(s.offsets.at(1).length, 100);
  EXPECT_EQ(s.offsets.at(1).whole_length(), 99.5);
  EXPECT_EQ(s.offsets.at(1).whole_radius(), 5.25);
  EXPECT_EQ(s.offsets.at(1).corner, 0.8);
  EXPECT_EQ(s.offsets.at(1).corner_wear, 0.1);
}

TEST(setup, work_offsets_keep_rotations) {
  const kadr::Setup s = read(R"({"work_offsets": {"common": {"X": 1}, "G54.1 P2": {"X": 1, "G17": 10, "G18": 0}}})");
  EXPECT_EQ(s.work_offsets.at("common"), (AxisValues{{"X", 1}}));
  EXPECT_EQ(s.work_offsets.at("G54.1 P2"), (AxisValues{{"X", 1}, {"G17", 10}}));
  EXPECT_EQ(refusal(R"({"work_offsets": {"54": {}}})"), "setup key 'work_offsets.54' must be named common, G54 or \"G54.1 P2\"");
}

TEST(setup, variables) {
  const kadr::Setup s = read(R"({"variables": {"#100": 2, "#3107": null, "#_ALM": 1, "#_FOFS1[12]": 3, "R2": 4}})");
  EXPECT_EQ(s.variables.at("#100"), 2);
  EXPECT_EQ(s.variables.at("#3107"), std::nullopt);
  EXPECT_EQ(s.variables.at("#_ALM"), 1);
  EXPECT_EQ(s.variables.at("#_FOFS1[12]"), 3);
  EXPECT_EQ(s.variables.at("R2"), 4);
  for (const char* name : {"100", "#", "#1x", "#_", "#_A[", "#_A[]", "#_A[x]", "#_alm", "R10", "#12345678"})
    EXPECT_EQ(refusal(std::string(R"({"variables": {")") + name + R"(": 1}})"),
              std::string("setup key 'variables.") + name + "' must be named #n, #_NAME, or R0 to R9");
}

// NCT 12.3.1: UENCV = 00001b, SENCV = 10001b, SDLCV = 11101b, UENTV = 00011b, SENTV = 10011b.
TEST(setup, tool_table) {
  const kadr::Setup s = read(R"({"tool_table": {"1": {"T": 10002001, "info": "UENCV"}, "2": {"info": "SENCV"}, "3": {"info": "UENTV"},
    "4": {"T": 150, "info": "SDLCV", "form": 2, "status": 3, "counter": 4, "life": 5, "warn": 6, "H": 7, "D": 8, "G": 9, "W": 10,
          "S": 11.5, "F": 12.5, "user_bits": 200, "user": [0.5, 0, 7]}, "6": {"info": "SENTV"}, "7": {"info": 4294967295}}})");
  EXPECT_EQ(s.tool_table.at(1).type, 10002001);
  EXPECT_EQ(s.tool_table.at(1).info, 1U);
  EXPECT_EQ(s.tool_table.at(2).info, 17U);
  EXPECT_EQ(s.tool_table.at(3).info, 3U);
  EXPECT_EQ(s.tool_table.at(6).info, 19U);
  EXPECT_EQ(s.tool_table.at(7).info, 4294967295U);
  ToolRow row{150, 29, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11.5, 12.5, 200, {0.5, 0, 7}};
  EXPECT_EQ(s.tool_table.at(4), row);
  for (const char* info : {"SENC", "VCNES", "SENCVV", "", "sencv"})
    EXPECT_EQ(refusal(std::string(R"({"tool_table": {"1": {"info": ")") + info + R"("}}})"),
              "setup key 'tool_table.1.info' must be a number, or five letters: U or S, E or D, N or L, C or T, I or V");
  EXPECT_EQ(refusal(R"({"tool_table": {"1": {"T": -1}}})"), "setup key 'tool_table.1.T' must be a whole number, 0 to 99999999");
  EXPECT_EQ(refusal(R"({"tool_table": {"1": {"status": 0.5}}})"),
            "setup key 'tool_table.1.status' must be a whole number, 0 to 4294967295");
}

TEST(setup, place_and_form_tables) {
  const kadr::Setup s = read(R"({"place_table": {"1/8": 2, "10/1": 0}, "form_table": {"5": {"left": 4, "right": 1, "geometry": 1}}})");
  EXPECT_EQ(s.place_table, (PocketTable{{{1, 8}, 2}, {{10, 1}, 0}}));
  EXPECT_EQ(s.form_table.at(5), (ToolForm{4, 1, 0, 0, 1}));
  for (const char* name : {"8", "1/", "/1", "1/2/3", "a/1", "1234567890/1"})
    EXPECT_EQ(refusal(std::string(R"({"place_table": {")") + name + R"(": 1}})"),
              std::string("setup key 'place_table.") + name + "' must be named magazine/pocket, \"10/1\"");
}

TEST(setup, parameters) {
  const kadr::Setup s = read(R"({"parameters": {"N107.4#0": 1, "N0106.X#1": 0, "CLRG#C03": 1, "N1301#CLR": 1, "N0605.1": "1",
    "N0308": 500.5}})");
  EXPECT_EQ(s.parameters.at({"0107", "4", "0"}), ParameterValue(1.0));
  EXPECT_EQ(s.parameters.at({"0106", "X", "1"}), ParameterValue(0.0));
  EXPECT_EQ(s.parameters.at({"CLRG", "", "C03"}), ParameterValue(1.0));
  EXPECT_EQ(s.parameters.at({"1301", "", "CLR"}), ParameterValue(1.0));
  EXPECT_EQ(s.parameters.at({"0605", "1", ""}), ParameterValue(std::string("1")));
  EXPECT_EQ(s.parameters.at({"0308", "", ""}), ParameterValue(500.5));
  EXPECT_EQ(text_of({"0107", "4", "0"}), "N0107.4#0");
  EXPECT_EQ(text_of({"107", "4", ""}), "N0107.4");
  EXPECT_EQ(text_of({"CLRG", "", "C03"}), "CLRG#C03");
  for (const char* name : {"308", "N", "N12345", "N1x", "N0308#", "N0308.", "N0308.x", "n0308", "N0308 ", "", "CL-R"})
    EXPECT_EQ(refusal(std::string(R"({"parameters": {")") + name + R"(": 1}})"),
              std::string("setup key 'parameters.") + name + "' must be named N0308, N0306#0, N0402.X or N0106.X#1");
  EXPECT_EQ(refusal(R"({"parameters": {"N0107": true}})"), "setup key 'parameters.N0107' must be a number or a text");
  EXPECT_EQ(refusal(R"({"parameters": {"N0107": 1, "N107": 2}})"), "setup key 'parameters.N107' must be given once");
}

TEST(setup, machine) {
  const kadr::Setup s = read(R"({"machine": {"*": {"rapid": 5000, "acceleration": null},
    "X": {"acceleration": 1000, "jerk_time": 0.05, "limits": [-10, 10], "zone3": [0, 100], "position_error": 0.1}}})");
  EXPECT_TRUE(s.machine.at("*").no_acceleration);
  EXPECT_EQ(s.machine.at("*").rapid, 5000);
  EXPECT_EQ(s.machine.at("*").jerk_time, std::nullopt);
  EXPECT_FALSE(s.machine.at("X").no_acceleration);
  EXPECT_EQ(s.machine.at("X").acceleration, 1000);
  EXPECT_EQ(s.machine.at("X").jerk_time, 0.05);
  EXPECT_EQ(s.machine.at("X").limits, std::pair(-10.0, 10.0));
  EXPECT_EQ(s.machine.at("X").zone3, std::pair(0.0, 100.0));
  EXPECT_EQ(s.machine.at("X").position_error, 0.1);
  EXPECT_EQ(refusal(R"({"machine": {"X": {"zone3": [1, 0]}}})"), "setup key 'machine.X.zone3' must be [least, most]");
  EXPECT_EQ(
      refusal(R"({"machine": {"X": {"limits": [1, 1]}}})"),
      "setup key 'machine.X.limits' must be [least, most], the second above the first, each a number, -10000000 to 10000000 mm or degrees");
  EXPECT_EQ(refusal(R"({"machine": {"X": {"acceleration": 1e-300}}})"),
            "setup key 'machine.X.acceleration' must be a number, 0.001 to 1000000000 mm/s² or degrees/s², or null: without limit");
  EXPECT_EQ(refusal(R"({"machine": {"X": {"rapid": -100}}})"),
            "setup key 'machine.X.rapid' must be a number, 0.001 to 1000000000 mm/min or degrees/min");
  EXPECT_EQ(refusal(R"({"feed": -100})"), "setup key 'feed' must be a number, 0 to 1000000000 mm/min");
  EXPECT_EQ(refusal(R"({"override": {"feed": -1}})"), "setup key 'override.feed' must be a number, 0 to 1000 %");
  EXPECT_EQ(refusal(R"({"spindle": {"1": {"rpm": -1}}})"), "setup key 'spindle.1.rpm' must be a number, 0 to 1000000 rev/min");
  EXPECT_EQ(refusal(R"({"machine": {"X": {"acceleration": 0}}})"),
            "setup key 'machine.X.acceleration' must be a number, 0.001 to 1000000000 mm/s² or degrees/s², or null: without limit");
}

TEST(setup, spindles) {
  const kadr::Setup s = read(R"({"spindle": {"1": {"rpm": 600, "dir": "cw"},
    "4": {"name": "S4", "channel": 2, "angle": 0, "ranges": [[50, 1000], [800, 4000]]}}})");
  EXPECT_EQ(s.spindle().rpm, 600);
  EXPECT_EQ(s.spindle().dir, "cw");
  EXPECT_EQ(s.spindle().angle, std::nullopt);
  EXPECT_EQ(s.spindles.at(4).name, "S4");
  EXPECT_EQ(s.spindles.at(4).channel, 2);
  EXPECT_EQ(s.spindles.at(4).angle, 0);
  EXPECT_EQ(s.spindles.at(4).ranges, (std::vector<std::pair<double, double>>{{50, 1000}, {800, 4000}}));
  EXPECT_EQ(refusal(R"({"spindle": {"17": {}}})"), "setup key 'spindle.17' must be named by a whole number, 1 to 16");
  EXPECT_EQ(refusal(R"({"spindle": {"1": {"dir": "left"}}})"), "setup key 'spindle.1.dir' must be \"cw\", \"ccw\" or \"stop\"");
  EXPECT_EQ(refusal(R"({"spindle": {"1": {"ranges": [5]}}})"), "setup key 'spindle.1.ranges' must be a list of [least, most]");
}

TEST(setup, probes) {
  const kadr::Setup s =
      read(R"({"probe_workpiece": {"tip_radius": 2, "hole": {"center": {"X": 50.3, "Y": 24.6}, "diameter": 40, "top": 0, "depth": 30}}})");
  ASSERT_TRUE(s.probe_hole);
  EXPECT_EQ(s.probe_hole->center_y, 24.6);
  EXPECT_EQ(s.probe_hole->depth, 30);
  EXPECT_FALSE(read(R"({"probe_workpiece": {}})").probe_hole);
  EXPECT_EQ(refusal(R"({"probe_workpiece": {"tip_radius": 2}})"), "setup key 'probe_workpiece' must be a table with 'hole'");
  EXPECT_EQ(refusal(R"({"probe": {"9": null}})"), "setup key 'probe.9' must be named by a whole number, 1 to 8");
}

TEST(setup, clock_and_channels) {
  const kadr::Setup s = read(R"({"clock": "2014-05-18T15:32:41", "channel": 2, "channels": {"1": {"axes": ["X"]}, "3": {"program": "M30"}},
    "signals": {"CP_NOWT": 1}})");
  EXPECT_EQ(s.clock, "2014-05-18T15:32:41");
  EXPECT_EQ(s.channel, 2);
  EXPECT_EQ(s.channels.at(1).axes, (std::vector<std::string>{"X"}));
  EXPECT_EQ(s.channels.at(3).program, "M30");
  EXPECT_EQ(s.signals.at("CP_NOWT"), 1);
  for (const char* clock : {"2014-05-18", "2014-02-30T00:00:00", "2014-13-01T00:00:00", "2014-05-18T24:00:00", "2014-05-18 15:32:41"})
    EXPECT_EQ(refusal(std::string(R"({"clock": ")") + clock + R"("})"),
              "setup key 'clock' must be a date and time, \"2014-05-18T15:32:41\"");
  EXPECT_EQ(refusal(R"({"channel": 9})"), "setup key 'channel' must be a whole number, 1 to 8");
  EXPECT_EQ(refusal(R"({"channels": {"0": {}}})"), "setup key 'channels.0' must be named by a whole number, 1 to 8");
}

/// The set-up accepts the state that an earlier run printed, except the parts for which there is no table.
TEST(setup, state_of_an_earlier_run) {
  const kadr::Setup s = read(R"({"shifts": {"G92": {"X": 60}}, "spindle": {"1": {"loop": "closed", "surface_speed": 100, "css_axis": 4,
    "master": null}, "2": {"master": 1}}})");
  EXPECT_EQ(s.shifts.at("G92").at("X"), 60);
  EXPECT_EQ(s.spindles.at(1).loop, "closed");
  EXPECT_EQ(s.spindles.at(1).surface_speed, 100);
  EXPECT_EQ(s.spindles.at(1).css_axis, 4);
  EXPECT_EQ(s.spindles.at(1).master, 0);
  EXPECT_EQ(s.spindles.at(2).master, 1);
}

TEST(setup, not_served_yet) {
  read(R"({"search": "", "kinematics": {}, "clock": null, "tool_table": null, "events": [], "channel": null, "plane": ""})");
  EXPECT_EQ(refusal(R"({"frame": {"origin": {"X": 5}}})"), "setup key 'frame' is not served by this control yet");
}

TEST(setup, a_search_names_a_block) {
  EXPECT_EQ(read(R"({"search": "N20"})").search, "N20");
  EXPECT_EQ(read(R"({"search": ":5"})").search, ":5");
  for (const char* const wrong : {"20", "N", "N2.5", "N123456789", "X5"})
    EXPECT_NE(refusal(std::string(R"({"search": ")") + wrong + R"("})").find("a block number"), std::string::npos) << wrong;
}

TEST(setup, unknown_key_names_the_nearest) {
  EXPECT_EQ(refusal(R"({"ofsets": {}})"), "unknown setup key 'ofsets'; did you mean 'offsets'?");
  EXPECT_EQ(refusal(R"({"override": {"fed": 10}})"), "unknown setup key 'override.fed'; did you mean 'feed'?");
}

TEST(setup, wrong_forms) {
  EXPECT_EQ(refusal(R"({"diameter": {"X": 1}})"), "setup key 'diameter.X' must be true or false");
  EXPECT_EQ(refusal(R"({"plane": "X"})"), "setup key 'plane' must be the names of its two axes, \"XY\"");
  EXPECT_EQ(refusal(R"({"start": {"X": "1"}})"), "setup key 'start.X' must be a number, at most 10000000");
  EXPECT_EQ(refusal(R"({"zeros": {"a": {}}})"), "setup key 'zeros.a' must be named by a whole number, 1 to 9");
  EXPECT_EQ(refusal(R"({"points": [2]})"), "setup key 'points' must be a list of numbers, 0 to 1");
  EXPECT_EQ(refusal(R"([])"), "setup key 'setup' must be a table { … }");
  EXPECT_NE(refusal("{").find("the text ends"), std::string::npos);
  EXPECT_FALSE(load_setup("/nowhere/setup.json"));
  EXPECT_EQ(refusal("{\"feed\": 1,\n\"zeros\": {\"1\": {\"X\": \"a\"}}}"), "setup key 'zeros.1.X' must be a number, at most 10000000");
}

}  // namespace
}  // namespace kadr::setup_test
