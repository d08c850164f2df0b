// control/nct/axes/gearbox, coupling: what no case's trace shows: the helix of a gearbox, errors in the set-up, warnings. NCT 20.

#include <cmath>

#include "control/run_program.h"

namespace kadr::coupling_test {
namespace {

using namespace test;

constexpr const char* gear = R"("axes": ["X", "Y", "Z", "C"], "parameters": {"N0106.C#1": 1, "N1801": "S", "N1802": "C", "N1803": "Z"})";

std::vector<Couple> couples(const std::string& program, const std::string& setup = gear) {
  std::vector<Couple> all;
  const Run made = run("nct", program, parse_setup("{" + setup + "}").value());
  EXPECT_EQ(made.first_alarm(), "");
  for (const Action& action : made.actions)
    if (const auto* const couple = std::get_if<Couple>(&action.what)) all.push_back(*couple);
  return all;
}

// NCT 20.1.3: k = 360 sin P / (pi T Q); for T20 Q5 P15 |k| = 0.29658 degrees/mm.
TEST(gearbox, helix_by_module) {
  const auto all = couples("M3 S300\nG81.8 T20 L2 R1 Q5 P15\n");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all[0].helix, 0.29658, 1e-5);
  EXPECT_EQ(all[0].along, "Z");
}

TEST(gearbox, helix_by_diametral_pitch) {
  const auto inch = couples("G20\nG81.8 T20 L2 Q5.08 P15\n");
  const auto metric = couples("G81.8 T20 L2 Q5 P15\n");
  ASSERT_EQ(inch.size(), 1U);
  EXPECT_NEAR(inch[0].helix, metric[0].helix, 1e-12);
}

TEST(gearbox, helix_later_keeps_the_ratio_and_a_new_ratio_ends_it) {
  const auto all = couples("M3 S300\nG81.8 T20 L-2\nG81.8 Q5 P-15\nG81.8 T16\n");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].helix, 0);
  EXPECT_EQ(all[1].ratio, -0.1);
  EXPECT_NEAR(all[1].helix, -0.29658, 1e-5);
  EXPECT_EQ(all[2].helix, 0);
  EXPECT_EQ(all[2].along, "");
  EXPECT_EQ(all[2].ratio, 1.0 / 16);
}

TEST(gearbox, spindle_by_name_number_or_the_main_one) {
  const std::string axes = R"("axes": ["X", "Y", "Z", "C"], "spindle": {"1": {"name": "MAIN", "rpm": 100, "dir": "cw"},
                               "2": {"name": "SUB", "rpm": 700, "dir": "cw"}}, "parameters": {"N1802": "C", "N1801": )";
  for (const auto& [name, rpm] : {std::pair("S", 100.0), {"MAIN", 100.0}, {"SUB", 700.0}, {"S2", 700.0}}) {
    const auto all = couples("G81.8 T10\n", axes + "\"" + name + "\"}");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].rpm, rpm / 10) << name;
  }
  const test::Run none = run("nct", "G81.8 T10\n", parse_setup("{" + axes + "\"S17\"}}").value());
  EXPECT_EQ(none.first_alarm(), "coupling_parameter");
}

std::string setup_error(const std::string& json, const char* of = "nct") {
  const Control machine(control(of), parse_setup("{" + json + "}").value(), Program{"test", text_source("M30\n"), {}}, RunLimits{});
  return machine.setup_fault().en;
}

TEST(coupling, the_set_up_must_name_a_master) {
  const std::string event = R"("axes": ["X", "Y", "V"], "events": [{"when": {"code": "M41"}, "do": "synchronise", "axes": ["V"]}])";
  EXPECT_EQ(setup_error(event), "events: N2101.V is not the number of another axis");
  EXPECT_NE(setup_error(event + R"(, "parameters": {"N2101.V": 3})"), "");  // an axis names itself
  EXPECT_EQ(setup_error(event, "fanuc"), "events: no parameter of this control says which axis V follows");
  EXPECT_EQ(setup_error(event + R"(, "parameters": {"N2101.V": 2})"), "");
}

TEST(coupling, no_axis_follows_itself_through_others) {
  const std::string json = R"({"axes": ["X", "Y", "V"], "feed": 100, "parameters": {"N2101.V": 2, "N2101.Y": 3}})";
  Control machine(control("nct"), parse_setup(json).value(), Program{"test", text_source("G1 X1\n"), {}}, RunLimits{});
  int warnings = 0;
  machine.on_warning = [&](const AlarmReport& w) { warnings += w.alarm.id == AlarmId::coupling_parameter ? 1 : 0; };
  machine.couple_axes({"V", "Y"}, AxisLink::follows, true);
  EXPECT_EQ(warnings, 1);
}

}  // namespace
}  // namespace kadr::coupling_test
