// control/nct: an alarm leaves everything as it was: modes, variables, tables, spindles, calls. alarm_state_test.cpp does
// the same for the other controls.

#include "control/scene.h"

namespace kadr::nct_alarm_state_test {
namespace {

using namespace test;

ParameterKey key(const char* text) { return *parameter_key(text); }

kadr::Setup machine() {
  kadr::Setup s;
  s.axes = {"X", "Y", "Z", "C"};
  s.offsets[1] = {10, 2};
  s.offsets[2] = {20, 3};
  s.work_offsets = {{"G54", {{"X", 100}}}, {"G55", {{"Y", 200}}}, {"G54.1 P3", {{"Z", 7}}}};
  s.variables = {{"#500", 5.0}};
  s.reference_points = {{1, {{"X", 50}, {"Z", 60}}}, {2, {{"Z", 20}}}};
  s.spindles[1].name = "S";
  for (int row : {1, 2}) {
    s.tool_table[row].type = 70 + row;
    s.tool_table[row].info = s.tool_table[row].status = 1;
    s.tool_table[row].life = 9;
    s.tool_table[row].h = s.tool_table[row].d = row;
  }
  s.place_table = {{{1, 1}, 1}, {{1, 2}, 2}, {{10, 1}, 0}};
  s.parameters[key("N1333")] = 0.0;
  return s;
}

/// Blocks that show the whole state; they contain no program end.
const std::string shows =
    "#110=#4001\n#111=#4003\n#112=#4109\n#113=#4119\n#114=#4120\n#115=#4113\n#116=#5041\n#117=#5021\n#118=#8402\n#119=#10001\n#120=#5221\n"
    "#121=#4111\n#122=#4107\n#123=#4114\n#124=#1100\n#125=#3901\n#126=#4130\n#127=#199\n#128=#4115\n#129=PRM[1339]\n"
    "X7 Y3\nG91 X1 Y1 Z1 C10\nG90 G1 X1 F50\nG43 H1 Z3\nH2 Z4\nG49 Z5\nG55 X2\nG54 X3\nG54.1 P3 X4\nG54 G0 X0 Y0\nM3\nM5\nT72 M6\nT71\nM6\n"
    "G67\nG50.1\nG15\nG13.1\nG0 X2 C5\nG2 X8 Y1 R20\n";

/// Restates the modes and the position that a faulty motion may leave to the blocks after it.
const std::string restart = "G90 G17 G21 G0 X0 Y0 Z0 C0\n";

TEST(alarm_on_nct, leaves_everything_as_it_was) {
  const std::string head = "GOTO10\nO300\n#101=#101+1\nX#24 Y#25\nM99\nO301\nY1\nM99\nN10 F100\n#1=3\n#100=4\n";
  const Scene scenes[] = {
      {"nct", head + "G1 X1 Y1\n", shows, restart},
      {"nct", head + "G0 X1\nG16\nX5 Y45\n", "X6\nY20\n" + shows, restart},
      {"nct", head + "G51.1 X5\nG1 X2\n", "X6\nY20\n" + shows, restart},
      {"nct", head + "G51.1 X5\nG51 X1 Y2 Z3 P2\nG68 X4 Y5 R30\nG1 X2\n", "X6\nG68 X1 Y1 RI10\nY20\nG69\nG51 X0 P3\nX7\nG50\nX8\n" + shows,
       restart},
      {"nct", head + "G92 X5\nG52 Y3\nG1 X2\n", "G92 X6\nX7\nG52 X0 Y0\n" + shows, restart},
      {"nct", head + "G66 P301\nG1 X2\n", "X6\n" + shows, restart},
      {"nct", head + "T71 M6\nS500 M3\nT72\nG0 X2\n", "M5\n" + shows, restart},
      {"nct", head + "G91 G0 X1\nG95 S300 M4\n", "G90 G94\n" + shows, restart},
  };
  const char* faults[] = {
      "#1=7/0",
      "#500=1/0",
      "#530=[1",
      "#4001=5",
      "#10001=SQRT[-1]",
      "#5221=99999999",
      "#1100=2",
      "#3000=1(STOP)",
      "G1 X99999999 F77",
      "G1 X3 Z99999999",
      "G0 X[1/0]",
      "G2 X9 Y1 I50 J3",
      "G91 G2 X9 Y1 I50 J3",
      "G20 F5 G2 X9 Y1 I50 J3",
      "G95 F5 G2 X9 Y1 I50 J3",
      "S700 M3 G2 X9 Y1 I50 J3",
      "M4 M8 G2 X9 Y1 I50 J3",
      "T72 G2 X9 Y1 I50 J3",
      "T72 M6 G2 X9 Y1 I50 J3",
      "T72 M6 X99999999",
      "M6 X99999999",
      "G43 H2 G2 X9 Y1 I50 J3",
      "H2 D2 X99999999",
      "G55 X99999999",
      "G54.1 P3 X99999999",
      "G54.1 P100",
      "G18 Z99999999",
      "G61 X99999999",
      "G16 X99999999",
      "G92 X5 Q7",
      "G52 X5 Q7",
      "G10 L2 P1 X9 R7 M98 P999",
      "G10 L10 P1 R9 M98",
      "G10 L2 P1 X99999999",
      "G51.1 X5 Q7",
      "G28 X5 Q7",
      "G53 X5 Q7",
      "G4 P-1",
      "G65 P999 A1",
      "G65 A1",
      "G65 P300 A1 A2",
      "G65 P300 L0",
      "G66 P999",
      "G66.1 P999",
      "M98 P999 X5",
      "X5 M98 P999",
      "X5 S700 M3 M98 P999",
      "G65 <nothing.nct> A1",
      "M99 P777",
      "GOTO777",
      "IF[1EQ1]GOTO777",
      "END1",
      "FCLOS",
      "POPEN30",
      "DPRNT[A]",
      "G12.1 X5",
      "M3 M4",
      "M2 M30 Q7",
      "G17 G18",
      "AX[9]=5",
      "AX[1]=99999999",
      "M30 Q7",
      "G33 X5 F0",
      "(COMMENT) X5 Y",
      "G41 D1 G2 X5 R10",
      "G51 X0 Y0 P3 M98 P777",
      "G51 X0 I0",
      "G68 X9 Y9 R50 M98 P777",
      "G69 G50 G50.1 X0 M98 P777",
  };
  for (const Scene& scene : scenes)
    for (const char* fault : faults) EXPECT_EQ(differences(scene, fault, machine()), "") << scene.before << "fault: " << fault;
}

/// Codes and letters are bound to programs that do not exist or cannot be called.
TEST(alarm_on_nct, of_a_bound_code_leaves_everything_as_it_was) {
  kadr::Setup setup = machine();
  setup.parameters[key("N1704")] = 2000.0;
  setup.parameters[key("N1705")] = -2001.0;
  setup.parameters[key("N1720")] = 600.0;
  setup.parameters[key("N1733")] = 500.0;
  setup.parameters[key("N1746#4")] = 1.0;
  const Scene scene{"nct", "F100\nG1 X1\n", "#110=#199\n#111=#4120\n#112=#4113\n#113=#4001\n#114=#4109\nX2\nG91 X1\nY2\n", restart};
  for (const char* fault :
       {"G2000 X5", "G2001 X5", "M500 X5", "G0 X5 F7 M600", "T5", "G0 X5 T5 F7", "T5 X99999999", "T5 X5 Q7", "G91 X5 T5"})
    EXPECT_EQ(differences(scene, fault, setup), "") << fault;
}

TEST(alarm_on_nct, behind_a_motion_takes_the_motion_back) {
  const std::string calls = "G66 P301\nG1 X2 F100\n";  // O301's own motion does not call O301 again
  const auto good = run("nct", calls + "M30\nO301\nY1\nM99\n", machine());
  EXPECT_EQ(good.first_alarm(), "");
  const auto deep =
      run("nct", "F100\nM98 P310\nM30\nO310\n#1=#1+1\nIF[#1EQ16]GOTO5\nM98 P310\nN5 G66 P301\nN6 G1 X2\nM99\nO301\nY1\nM99\n", machine());
  EXPECT_EQ(deep.first_alarm(), "call_too_deep");
  EXPECT_TRUE(deep.motions().empty());
  EXPECT_EQ(deep.ending.position[0], -100);
}

// The table itself must be restored, not only the frame in force: the
// next G54 reads the table. M205 turns a spindle whose loop is open.
TEST(alarm_on_nct, a_work_offset_comes_back) {
  const auto setup = parse_setup(R"({"parameters": {"N0607.1#2": 1, "N0820.1": 201, "N0821.1": 10, "N0822.1": 30}})");
  for (const char* const system : {"L2 P1", "L2 P0"}) {
    const test::Run made = run("nct", "G10 " + std::string(system) + " X5 M205\nG55\nG54\nG0 X1\n", setup.value(), OnAlarm::go_on);
    EXPECT_EQ(made.first_alarm(), "spindle_loop_open");
    ASSERT_EQ(made.motions().size(), 1U) << system;
    EXPECT_EQ(made.motions()[0].machine[0], 1) << system;
  }
}

}  // namespace
}  // namespace kadr::nct_alarm_state_test
