// control: an alarm leaves everything as it was: modes, variables, offsets, position, calls. If a faulty block is
// skipped, the following blocks, which show the whole state, must act as if it had not been written.

#include <fmt/format.h>

#include "choices.h"
#include "control/random_path.h"
#include "control/scene.h"

namespace kadr::alarm_state_test {
namespace {

using namespace test;

kadr::Setup tables() {
  kadr::Setup s;
  s.offsets[1] = {10, 0};
  s.offsets[2] = {20, 0};
  s.work_offsets["G54"] = {{"X", 100}};
  s.work_offsets["G55"] = {{"Y", 200}};
  s.zeros[1] = {{"X", 50}};
  s.zeros[2] = {{"Y", 60}};
  return s;
}

const std::string shows_mach3 =
    "X4 Y30\nG4 P#1\nX#2 Y5\nG0 X#5221 Y#5211\nG91 X1 Y1 Z1\nG90 G1 X1 S700 T9 M6\nG43 H1 Z3\nG43 H2 Z4\nG49 Z5\nG55 X2\nG54 X3\nG59 P3 "
    "X4\nG54 G0 X0 Y0\n"
    "G92.3\nX7\nM3 M7\nM5 M9\nG15 G50 G69\n"
    "G0 X7 Y1\nG90 G2 X8 Y1 I0.5\nG83 X5 Y6 Z-3 R1 Q1\nX7\nG80\nG0 X1 Y2 Z3\n";

/// Restates the modes and the position that a faulty motion may leave to the blocks after it.
const std::string restart = "G90 G91.1 G17 G21 G0 X0 Y0 Z0\n";

TEST(alarm_on_mach3, leaves_everything_as_it_was) {
  const std::string start = "G21 F100 #1=3 #2=4\nG43 H1\nG10 L1 P3 Z7\n";
  const Scene scenes[] = {
      {"mach3", start + "G1 X1 Y1\n", shows_mach3, restart},
      {"mach3", start + "G0 X1\nG16\nX5 Y45\n", "X6\nY20\n" + shows_mach3, restart},
      {"mach3", start + "G1 X1\nG68 A1 B2 R30\nG51 X-1 Y1\nG1 X2\n", "X6\nY20\nG68 I1 R10\n" + shows_mach3, restart},
      {"mach3", start + "G92 X5\nG1 X2\n", "G92 X6\nX7\nG92.1\n" + shows_mach3, restart},
      {"mach3", start + "G81 X1 Y1 Z-1 R2\n", "G81 X2 Z-1 R2\nX3 R3\n" + shows_mach3, restart},
      {"mach3", start + "G83 X1 Y1 Z-1 R2 Q0.7\n", "G83 X2 Z-1 R2 Q0.7\nX3 Q1\n" + shows_mach3, restart},
      {"mach3", start + "G20 G93\nG0 X1\n", "G94 F3 G1 X2\n" + shows_mach3, restart},
  };
  const char* faults[] = {
      "#1=7 G1 X1 Y",
      "#1=7 #2=8 G2 X9 Y1 I50 J3",
      "#5221=9 G2 X9 Y1 I50 J3",
      "#1=1 #20000=5",
      "#1=9 X[1/0]",
      "#5221=9 M98 P999",
      "G10 L1 P1 Z9 R0 M98",
      "G10 L2 P2 X9 M98",
      "G92 X9 M98 P999",
      "G52 X9 M98 P999",
      "S1000 M3 G2 X9 Y1 I50 J3",
      "T3 M6 G2 X9 Y1 I50 J3",
      "G20 F5 G2 X9 Y1 I50 J3",
      "G43 H2 G2 X9 Y1 I50 J3",
      "G55 G2 X9 Y1 I50 J3",
      "G19 G2 Y9 Z1 J50 K3",
      "G91 G61 G2 X9 Y1 I50 J3",
      "G93 F3 G2 X9 Y1 I50 J3",
      "M7 M8 G2 X9 Y1 I50 J3",
      "G68 A3 B4 R70 M98 P999",
      "G51 X3 M98 P999",
      "G16 M98 P999",
      "G15 M98 P999",
      "G81 X1 Z-1 R-5",
      "G83 X1 Z-1 R3 Q0",
      "G82 X1 Z-1 R3 P-1",
      "G28 X5 M98 P999",
      "G0 G53 X5 M98 P999",
      "G59 P3 M98",
      "M6 T5 M98 P999",
      "G0 X3 M98 P999",
      "G1 X3 Y99999999",
      "X3 Y999999999 Z99999999",
      "G31 X50 M98 P999",
      "G12 I5 M98 P999",
      "G80 M98 P999",
      "G92.1 M98 P999",
      "G92.2 M98 P999",
      "G98 G90.1 M48 M98 P999",
      "G41 D0.5",
      "G41 P0 G18 M98 P999",
      "M3 S0 M98 P999",
      "G4 P-1 F77",
      "F50 G64 P-1",
      "G99 R9 X3 E4",
      "M98 P999 L3",
      "M0 M98",
      "G17 G18",
      "(MSG,x) G2 X9 Y1 I50 J3",
      "G81 X1 Y1 Z-1 R2 M98 P999",
  };
  for (const Scene& scene : scenes)
    for (const char* fault : faults) EXPECT_EQ(differences(scene, fault, tables()), "") << scene.before << "fault: " << fault;
}

TEST(alarm_on_mach3, in_a_cycle_keeps_its_sticky_words) {
  const Scene scene{"mach3", "G21 F100 G98\nG83 X1 Y1 Z-1 R2 Q0.7\n", "X2\nG91 X1\nG90 Y9\n"};
  for (const char* fault : {"X3 R-5", "X3 Z8", "X3 Q0", "X3 Q-1 R9", "X3 L0", "X3 R4 L1.5", "Y3 R4 A7", "X99999999 R4"})
    EXPECT_EQ(differences(scene, fault, {}), "") << fault;
}

const std::string shows_2c42 =
    "N900 X+R1 Y4000\nN901 G91 X1000 Y1000 Z1000\nN902 G90 G1 X1000 S700 M3\nN903 G43 D1 Z3000\nN904 D2 Z4000\nN905 G40 Z5000\nN906 G54 "
    "X2000\nN907 G53 X3000\n"
    "N908 H2\nN909 G91 X1000 M20\nN910 G90 G0 X0 Y0\nN911 G2 X8000 Y0 I4000 J0\nN912 L83\nN913 G1 X1000\nN914 M2\n";

TEST(alarm_on_2c42, leaves_everything_as_it_was) {
  const std::string start = "%\nN1 G1 X1000 Y2000 F300 D1 R0+60 R1-5000 R2+2000 R3+900\nN2 G43 Z100\n";
  const Scene scenes[] = {
      {"s2c42", start, shows_2c42, "N700 G90 G17 G0 X0 Y0 Z0\n"},
      {"s2c42", start + "N3 G91 G18\n", "N800 X500\nN801 G17\n" + shows_2c42, "N700 G90 G17 G0 X0 Y0 Z0\n"},
      {"s2c42", start + "N3 G54 X5000\nN4 G92 X1000\n", "N800 X500\n" + shows_2c42, "N700 G90 G17 G0 X0 Y0 Z0\n"},
      {"s2c42", start + "N3 H2\nN4 X1000\n", "N800 G91 X500 M20\nN801 G90\n" + shows_2c42, "N700 G90 G17 G0 X0 Y0 Z0\n"},
  };
  const char* faults[] = {
      "N5 R1+5 G1 Z+R9",
      "N5 R1+5 L77",
      "N5 D02 L77",
      "N5 G57 D2 L77",
      "N5 G2 X100 Y9000 I0 J7000",
      "N5 M3 S500 G2 X100 Y9000 I0 J7000",
      "N5 G44 D2 Z500 L77",
      "N5 H5 L77",
      "N5 L77 H5",
      "N5 G92 /2/ L77",
      "N5 G92 X500 Y3 L77",
      "N5 H5 G2 X100 Y9000 I0 J7000",
      "N5 T05 M6 L77",
      "N5 G0 X5000 H3 L77",
      "N5 G25 X0 L77",
      "N5 G26 X500 L77",
      "N5 M17 X5 W3",
      "N5 G20 M8 L77",
      "N5 F999 X12345678",
      "N5 G41 G36 X500 L77",
      "N5 G4 E20 X500 L77",
      "N5 G9 G0 X500 L77",
      "N5 R3+0 L83",
      "N5 R0+0 L83",
      "N5 G19 G91 L84 R1+7 L77",
      "N5 X5000 X6000",
      "N5 G0 G1",
      "N5 L8",
      "N5 L7700",
      "N5 G37 G2 X1000",
      "N5 R9+1 X5000 Y+R8",
      "N5 M60 M13 L77",
  };
  for (const Scene& scene : scenes)
    for (const char* fault : faults) EXPECT_EQ(differences(scene, fault, tables()), "") << scene.before << "fault: " << fault;
}

TEST(alarm_on_correctors, leaves_what_correctors_have_added) {
  const Scene scene{"correctors", "% LF\nN1 G91 G17 LF\nN2 G01 X10. L17 F100 LF\n",
                    "N4 X5. LF\nN5 X5. L17 LF\nN6 G40 X-10. L17 LF\nN7 X1. LF\nN8 M02 LF\n", "N3 G90 G17 G01 X0. Y0. LF\nN3 G91 LF\n"};
  kadr::Setup s;
  s.correctors = {{17, 2.5}, {18, 1}};
  for (const char* fault :
       {"N3 X5. L17 L98 LF", "N3 G41 X5. Y3. L17 LF", "N3 X5. L1 17 L1 1000 LF", "N3 X9999999. L17 LF", "N3 G40 L1 17 L9 17 LF"})
    EXPECT_EQ(differences(scene, fault, s), "") << fault;
}

TEST(alarm, emits_nothing_of_its_block) {
  const auto r = run("mach3", "F100\nG0 X1\nS1000 M3 T4 M6 M8 G2 X5 Y5 I50 J3\n");
  EXPECT_EQ(r.first_alarm(), "radius_mismatch");
  EXPECT_EQ(r.actions.size(), 2u);  // the initial frame and G0
}

// One fault gives one alarm: the blocks after it use the feed that was missing. With inverse-time feed each block needs its own.
TEST(alarm, a_missing_feed_is_told_once) {
  for (const char* const control : {"grbl", "linuxcnc", "fanuc"}) {
    const auto once = run(control, "G21 G90\nG0 X0 Y0\nG1 X1\nY1\nX0\nG1 X5 F100\nX0\nM2\n", {}, OnAlarm::go_on);
    ASSERT_EQ(once.alarms.size(), 1U) << control;
    EXPECT_EQ(once.alarms[0].origin.line, 3U) << control;
  }
  EXPECT_EQ(run("grbl", "G21 G90\nG93\nG1 X1\nY1\nM2\n", {}, OnAlarm::go_on).alarms.size(), 2U);
}

// ---- a fault at any block of any path

RC_GTEST_PROP(alarm, at_any_block_leaves_what_was_before_and_the_rest_goes_on, ()) {
  static constexpr const char* faults[] = {"G2 X1 Y1 I500 J3",     "X[1/0] #1=5", "G1 X1 E5",         "#5=3 M98 P999",
                                           "G91 G20 G18 M98 P999", "X1 X2",       "G10 L2 P1 X7 M98", "?"};
  Choices choose = choices(300);
  const Path path = random_path(choose, 3);
  Writer writer({Dimensions::mixed}, &choose);
  const std::size_t place = choose.below(path.size() + 1);
  const std::string fault = std::string(choose.of(faults)) + "\n";
  const Axes at = place == 0 ? Axes{} : path[place - 1].to;
  std::string before = "G21 F100\n", after = fmt::format("G90 G91.1 G17 G21 G0 X{:.9f} Y{:.9f} Z{:.9f}\n", at[0], at[1], at[2]);
  for (std::size_t i = 0; i < path.size(); ++i) (i < place ? before : after) += writer.block(path[i]);
  const auto cut = run("mach3", before);
  const auto plain = run("mach3", before + after);
  const auto stopped = run("mach3", before + fault + after);
  const auto passed = run("mach3", before + fault + after, {}, OnAlarm::go_on);
  RC_ASSERT(stopped.alarms.size() == 1u);
  RC_ASSERT(stopped.alarms[0].origin.line == place + 2);
  RC_ASSERT(exactly(stopped.actions) == exactly(cut.actions));
  RC_ASSERT(exactly(stopped.ending) == exactly(cut.ending));
  RC_ASSERT(passed.alarms.size() == 1u);
  RC_ASSERT(passed.actions_at_alarm[0] == cut.actions.size());
  RC_ASSERT(exactly(passed.actions) == exactly(plain.actions));
  RC_ASSERT(exactly(passed.ending) == exactly(plain.ending));
}

}  // namespace
}  // namespace kadr::alarm_state_test
