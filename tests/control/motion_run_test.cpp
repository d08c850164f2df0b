// control/block/motion_run: blocks that extend a run of plain motions do the same as by the general path. A control that returns after
// each block never extends a run: it is the reference.

#include <random>

#include "control/run_program.h"

namespace kadr::motion_run_test {
namespace {

struct Given {
  std::vector<std::string> actions;
  std::string alarms, ending;
  friend bool operator==(const Given&, const Given&) = default;
};

Given run_as(const std::string& id, const std::string& program, const Setup& setup, bool each_block) {
  Control control(test::control(id), setup, Program{"p", text_source(program), {}}, RunLimits{});
  Given given;
  control.on_warning = [&](const AlarmReport& w) {
    given.alarms += std::string(name_of(w.alarm.id)) + std::to_string(w.origin.line) + "\n";
  };
  if (each_block) control.return_each_block();
  ActionBatch batch;
  for (int alarms = 0; alarms < 50;) {
    const Control::State state = control.run(batch);
    for (const Action& action : batch) {
      std::string line = test::exactly(action) + " " + std::to_string(action.origin.line) + " " + std::to_string(action.origin.number);
      if (const auto* const m = std::get_if<Motion>(&action.what))
        line += " " + std::to_string(m->join) + std::to_string(m->smoothing) + std::to_string(int(m->corner_speed)) +
                std::to_string(m->in_position) + std::to_string(m->own_override) + std::to_string(m->inch) + std::to_string(m->system) +
                std::to_string(int(m->along)) + std::to_string(m->detail != nullptr) + " " + std::to_string(m->side) + " " +
                std::to_string(m->tool_radius) + " " + std::to_string(m->radius_offset) + std::to_string(m->nose) +
                std::to_string(int(m->side_step)) + std::to_string(int(m->join_corner)) + std::to_string(int(m->entry)) +
                std::to_string(m->corner_first) + std::to_string(int(m->in_hole)) + std::to_string(m->of_cycle);
      given.actions.push_back(std::move(line));
    }
    if (state == Control::State::ended) break;
    if (state == Control::State::needs_probe) control.answer({true, std::get<Motion>(batch.back().what).to});
    if (state != Control::State::stopped) continue;
    ++alarms;
    given.alarms += std::string(name_of(control.report().alarm.id)) + std::to_string(control.report().origin.line) + "\n";
    control.go_on();
  }
  given.ending = test::exactly(control.ending());
  return given;
}

/// Writes mostly lines of one or two shapes; now and then a line that changes what they mean.
std::string program_of(const std::string& id, std::mt19937& choose) {
  const auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(choose); };
  static const std::map<std::string, std::vector<std::string>> others = {
      {"mach3", {"G90",        "G91",       "G0",     "G1 F300",
                 "F200",       "G20",       "G21",    "G41 P1",
                 "G40",        "G52 X5",    "G92 X1", "G68 A0 B0 R30",
                 "G69",        "G51 X2",    "G50",    "G16",
                 "G15",        "G54",       "G55",    "G81 X1 Z-1 R1 F9",
                 "G80",        "G61",       "G64",    "M3 S5",
                 "G93",        "G94",       "G43 H1", "G49",
                 "G4 P1",      "X[#1]",     "#1=5",   "M48",
                 "G31 X3 F10", "X99999999", "Z1E9",   "G53 G0 X1",
                 "G28 X1",     "A50",       "X1 X2",  "",
                 "(c)",        "/X7"}},
      {"linuxcnc",
       {"G90",
        "G91",
        "G0",
        "G1 F300",
        "F200",
        "G20",
        "G21",
        "G41.1 D1",
        "G40",
        "G52 X5",
        "G92 X1",
        "G92.1",
        "G10 L2 P1 R30",
        "G10 L2 P1 R0",
        "G54",
        "G55",
        "G81 X1 Z-1 R1 F9",
        "G80",
        "G61",
        "G64 P0.1",
        "M3 S5",
        "G93",
        "G94",
        "G95",
        "G43 H1",
        "G49",
        "G4 P1",
        "X[#1]",
        "#1=5",
        "#<a>=3",
        "X#<a>",
        "M48",
        "G38.3 X3",
        "X99999999",
        "G53 G0 X1",
        "G28 X1",
        "A50",
        "X1 X2",
        "@5 ^30",
        "(c)",
        "/X7",
        "G7",
        "G8",
        "G90.1",
        "G91.1",
        "G2 X3 R9",
        "M70",
        "M72",
        "G1",
        "O1 if [1]",
        "O1 endif"}},
      {"nct", {"G90",     "G91",           "G0",      "G1 F300",    "F200",      "G20",    "G21",    "G41 D1", "G40",    "G52 X5",
               "G92 X1",  "G68 X0 Y0 R30", "G69",     "G51.1 X2",   "G50.1",     "G16",    "G15",    "G54",    "G55",    "G81 X1 Z-1 R1 F9",
               "G80",     "G61",           "G64",     "M3 S5",      "G95",       "G94",    "G43 H1", "G49",    "G4 P1",  "X[#1]",
               "#1=5",    "#3004=7",       "#3004=0", "G31 X3 F10", "X99999999", "G53 X1", "G28 X1", "U5",     "X1 U2",  "IX5",
               "G5.1 Q2", "G5.1 Q0",       "G12.1",   "G13.1",      "/X7",       "X5,C1",  "N0 X3",  "C370",   "C20 X4", "G66 P9100",
               "G67",     "G9 X4",         "G63",     "G1 X3 C4"}},
      {"gost", {"G90", "G91",    "G0",  "G1 F300", "F200",  "G41 D1", "G40",   "G92 X1", "G81 X1 Z-1 R1 F9", "G80", "M3 S5", "G95",
                "G94", "G43 H1", "G49", "G4 P1",   "G9 X4", "U5",     "W7 X2", "G1 X F"}},
      {"correctors", {"G90", "G91", "G0", "G1 F300", "F200", "G41 L17 X5", "G40", "L17 X9", "M3 S5", "G4 F1"}},
      {"s2c42", {"G90",     "G91", "G00",   "G01 F300",   "F200", "F6000",     "G41 D01", "G40", "G92 X1", "M03 S05", "G04 E50", "G09 X4",
                 "G43 D01", "G49", "G25 X", "G17 G09 X5", "G18",  "X1 Y2 M00", "L81 Z1",  "G95", "G94",    "L90 X5",  "G60",     "G61"}},
      {"grbl", {"G90",          "G91",       "G0",     "G1 F300", "F200",  "G20",      "G21", "G92 X1", "G92.1",
                "G10 L2 P1 X3", "G54",       "G55",    "G93",     "G94",   "G43.1 Z3", "G49", "G4 P1",  "M3 S5",
                "G38.3 X3 F10", "G53 G0 X1", "G28 X1", "A50",     "X1 X2", "G2 X3 R9", "(c)", "/X7",    "$J=X1F100"}}};
  static const std::map<std::string, std::string> likes{{"fanuc", "nct"}, {"haas", "nct"}, {"mitsubishi", "nct"}};
  const auto like = likes.find(id);
  const auto& lines = others.at(like == likes.end() ? id : like->second);
  const bool is_numbered = id == "s2c42", begins_with_sign = id == "gost" || id == "correctors" || is_numbered;
  std::string text = begins_with_sign ? "%\n" : "";
  const auto number = [&](std::size_t i) { return is_numbered ? "N" + std::to_string(i + 1) + " " : std::string(); };
  text += number(0) + "G90 G01 F100\n";
  static const char* const feeds[] = {"F100 ", "F200 ", "F50.5 ", "F7. ", "F0 ", "F6000 "};
  std::string form;
  for (std::size_t i = 0; i < 80; ++i) {
    if (below(12) == 0) {
      text += number(i) + lines[below(lines.size())] + "\n";
      continue;
    }
    text += number(i);
    if (form.empty() || below(8) == 0) {
      static const char* const forms[] = {"X",   "XY",  "XYZ", "1X", "1XZ", "YX", "0X",  "NXY", "Z",   "ZX", "1XF", "F1X",  "XFY", "XYF",
                                          "0XF", "2cF", "QXF", "c",  "pc",  "2c", "3cZ", "3h",  "p2h", "h",  "2k",  "p2kF", "3XYc"};
      form = forms[below(std::size(forms))];
    }
    for (const char c : form) {
      if (c == 'N') text += is_numbered ? "" : "N" + std::to_string(i + 1) + " ";
      else if (c >= '0' && c <= '3') text += std::string("G0") + c + " ";
      else if (c == 'F') text += feeds[below(3) == 0 ? below(std::size(feeds)) : 0];
      else if (c == 'Q') text += below(6) == 0 ? "G91 G94 " : "G90 G94 ";
      else if (c == 'p') text += below(6) == 0 ? "G18 " : "G17 ";
      else if (c == 'c') text += "I" + std::to_string(below(9)) + " J-2.5 ";  // whole circles if the block has no end point
      else if (c == 'k') text += "J" + std::to_string(below(3)) + " K" + std::to_string(below(3)) + " ";
      else if (c == 'h') text += "X" + std::to_string(2 * below(2)) + " I" + std::to_string(below(2)) + " ";  // sometimes half circles
      else
        text += c + std::to_string(static_cast<int>(below(200)) - (id == "gost" && below(4) != 0 ? 0 : 100)) +
                (!is_numbered && below(2) == 0 ? ".5 " : " ");
    }
    text += "\n";
  }
  return text;
}

/// Writes contours with cutter compensation, and holes of drilling cycles; now and then a line that ends or changes them.
std::string contour_of(const std::string& id, std::mt19937& choose) {
  const auto below = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(choose); };
  static const std::map<std::string, std::string> begins{{"linuxcnc", "G41.1 D4"}, {"mach3", "G41 P2"}, {"s2c42", "G41 D01"}};
  const auto own = begins.find(id);
  const std::string begin = own == begins.end() ? "G41 D1" : own->second;
  static const char* const changes[] = {"G40",    "G40 X1 Y9", "G91",   "G90",      "M3 S5",      "(c)",       "G18 G1 X5", "G17",
                                        "G92 X3", "G0 X7",     "G55",   "G54",      "F70",        "G4 P1",     "G68 X0",    "G42",
                                        "G38 X4", "G39",       "G9 X4", "X1 Y2 Z3", "G1 G17 X20", "G80",       "G98",       "G99",
                                        "Z-6",    "R3",        "X5 L2", "G61",      "Z4 X8",      "G53 G0 X1", "G20",       "G21",
                                        "G93 X1", "G94",       "G95",   "Q0.25",    "P0.5",       "G7 X",      "A5 X3",     "I1"};
  static const char* const cycles[] = {"G81 X1 Y1 Z-5 R2 F100", "G82 X2 Z-5 R2 P0.1",    "G83 X3 Z-5 R2 Q1", "G73 X4 Z-5 R2 Q1.5",
                                       "G84 X1 Z-5 R2 F100",    "G76 X1 Z-5 R2 I1 J1",   "G85 X1 Z-5 R2",    "G86 X1 Z-5 R2 P0",
                                       "G81 X1 Z-5 R-9 F100",   "G89 X1 Y1 Z-5 R2 P0.1", "G81 X5 Z-8",       "G83 X3 Z-5"};
  const bool drills = id != "s2c42" && id != "grbl" && below(3) == 0;
  std::string text = id == "gost" || id == "correctors" || id == "s2c42" ? "%\n" : "";
  std::size_t line = 0;
  const auto add = [&](const std::string& words) {
    text += (id == "s2c42" ? "N" + std::to_string(++line) + " " : std::string()) + words + "\n";
  };
  add(drills ? "M3 S500" : "G90 G17 G01 F100 X0 Y0");
  if (!drills) add(begin + " G01 X10 Y5");
  int x = 10, y = 5;
  for (int i = 0; i < 60; ++i) {
    const int r = 1 + below(6), right = below(2) == 0 ? 1 : -1;
    const auto at = [](char letter, int value) { return " " + std::string(1, letter) + std::to_string(value); };
    if (below(14) == 0) add(drills && below(2) == 0 ? cycles[below(int(std::size(cycles)))] : changes[below(int(std::size(changes)))]);
    else if (below(40) == 0) add(begin + " G01 X1 Y2");
    else if (drills && (i == 0 || below(12) == 0)) add(cycles[below(int(std::size(cycles)))]);
    else if (drills) add("X" + std::to_string(below(90)) + (below(3) == 0 ? at('Y', below(90)) : ""));
    else if (below(3) == 0)
      add("G0" + std::to_string(2 + below(2)) + at('X', x += 2 * r * right) + at('Y', y) + at('I', r * right) + at('J', 0));
    else if (below(4) == 0) add("G0" + std::to_string(2 + below(2)) + at('X', x += 3 * right) + at('Y', y += 4) + at('R', 5 * right));
    else if (below(3) == 0) add("G01" + at('X', x += r) + (below(2) == 0 ? " F80" : ""));
    else if (below(5) == 0) add("Z" + std::to_string(-r));
    else add("G01" + at('X', x -= r) + at('Y', y += 2 * r));
  }
  return text;
}

/// Returns a loop of motions whose words are expressions, with other macro statements between them.
std::string loop_of(std::mt19937& choose) {
  const auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(choose); };
  static const char* const motions[] = {"X[#1*2]",     "G1 X[#1] Y#2 F100", "Y#3",       "Z[#1-#2]",     "G0 X[#1]",   "G2 I[#1+1] J0",
                                        "X2 I[#1]",    "N5 X[#1]",          "X#1 F[#4]", "X#1 F[#1*50]", "G1 X#2 Y#1", "G3 I-5 J#1",
                                        "X#4 Y[#1/2]", "G1 G90 X#1 F100",   "X1",        "G1 Y2 X[#1]",  "Z#1",        "Y[#4113/9]",
                                        "Z[#4109/50]", "X[#4114+#4115]"};
  static const char* const others[] = {"#2=#1*2",
                                       "#3=#0",
                                       "#3=5",
                                       "#4=100",
                                       "#5221=#1",
                                       "#2001=#1",
                                       "#3004=7",
                                       "#3004=0",
                                       "#100=#1",
                                       "IF[#1EQ2]GOTO9",
                                       "G65 P9100 A#1 F5",
                                       "M98 P9101",
                                       "X[#1] M98 P9101",
                                       "G91 M98 P9101",
                                       "G90",
                                       "G91",
                                       "G17",
                                       "G68 X0 Y0 R[#1]",
                                       "G69",
                                       "G41 D1",
                                       "G40",
                                       "G4 P1",
                                       "X[99999999*#1]",
                                       "/X[#1]",
                                       "(c)",
                                       "G66 P9100 A1",
                                       "G67",
                                       "G65 P9102 A#1",
                                       "G#1 X1",
                                       "X[1/#5]",
                                       "G43 H1 Z#1",
                                       "G49",
                                       "IX[#1]",
                                       "G20",
                                       "G21",
                                       "G54.1P1"};
  std::string text = "%\nG90 G1 F100 X0\n#1=0\n#2=1\n#4=100\nWHILE[#1LT6]DO1\n";
  for (std::size_t i = 0; i < 14; ++i)
    text += std::string(below(4) == 0 ? others[below(std::size(others))] : motions[below(std::size(motions))]) + "\n";
  return text +
         "N9 #1=#1+1\nEND1\nM30\nO9100\nG1 X#1 Y[#1+1] F100\nM99\nO9101\nX#1\nG91\nX[#2]\nG90\nM99\n"
         "O9102\n#1=#1+1\nX#1\nX[#1]\nM99\n%\n";
}

class MotionRuns : public testing::TestWithParam<const char*> {};

TEST_P(MotionRuns, are_the_general_way) {
  const std::string id = GetParam();
  std::mt19937 choose(11);
  const bool macros = id == "nct" || id == "fanuc" || id == "haas" || id == "mitsubishi";
  const std::string axes = id == "nct" ? R"("axes": ["X", "Y", "Z", "C"], "parameters": {"N0106.C#1": 1, "N0107.C#0": 1}, )" : "";
  const auto setup = parse_setup("{" + axes + R"("start": {"X": 3, "Z": 50}, "offsets": {"1": {"length": 10, "radius": 2}}})");
  ASSERT_TRUE(setup) << setup.error();
  std::size_t motions = 0;
  for (int i = 0; i < (macros ? 1450 : 850); ++i) {
    const std::string program = i < 600 ? program_of(id, choose) : i < 850 ? contour_of(id, choose) : loop_of(choose);
    const Given fast = run_as(id, program, *setup, false), general = run_as(id, program, *setup, true);
    motions += fast.actions.size();
    ASSERT_EQ(fast.alarms, general.alarms) << program;
    ASSERT_EQ(fast.ending, general.ending) << program;
    ASSERT_EQ(fast.actions.size(), general.actions.size()) << program;
    for (std::size_t a = 0; a < fast.actions.size(); ++a) ASSERT_EQ(fast.actions[a], general.actions[a]) << program;
  }
  EXPECT_GT(motions, 5000U);
}

INSTANTIATE_TEST_SUITE_P(motion_run, MotionRuns,
                         testing::Values("mach3", "linuxcnc", "nct", "gost", "correctors", "s2c42", "grbl", "fanuc", "haas", "mitsubishi"),
                         [](const auto& control) { return std::string(control.param); });

}  // namespace
}  // namespace kadr::motion_run_test
