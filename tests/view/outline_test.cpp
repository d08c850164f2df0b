// The outline of programs of several controls: programs, tools with their headings, cycles, labels, structure blocks.

#include "view/structure/outline.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "config/control/control_file.h"

namespace kadr::outline_test {

void write(const ControlDef& def, const std::vector<OutlineEntry>& entries, const std::string& before, std::string& to) {
  for (const OutlineEntry& one : entries) {
    const Text* const meaning = meaning_of(def, one);
    to += fmt::format("{}{} {} {}-{}{}\n", before, name_of(one.kind), one.name, one.first, one.last, meaning == nullptr ? "" : " +");
    write(def, one.inside, before + "  ", to);
  }
}

/// Returns the outline, a line for each entry: kind, name, first and last line from 0, and + if the control's file says what a cycle does.
std::string outline_of(const std::string& control, const std::string& text) {
  const auto def = *load_control(control);
  Outliner outliner(def);
  std::istringstream in(text);
  std::size_t lines = 0;
  for (std::string line; std::getline(in, line);) outliner.take(lines++, names_of_line(def, line));
  std::string all;
  write(def, outliner.finish(lines), "", all);
  return all;
}

struct Case {
  const char *name, *control, *text, *outline;
};

class Outline : public testing::TestWithParam<Case> {};

TEST_P(Outline, HasTheStructureOfTheProgram) { EXPECT_EQ(outline_of(GetParam().control, GetParam().text), GetParam().outline); }

const Case cases[] = {
    {"Fanuc", "fanuc",
     "%\nO0001 (PLATE)\nG90 G54\n(FACE MILL)\nT1 M6\nG1 X0\n(DRILL 8)\nT2 M6\nG81 X0 Z-5 R2\nX10\nG81 X20\nG80\nG81 X30\nG83 X40 "
     "Q1\nG80\nM30\n"
     "O200\nG1 X5\nM99\n",
     "program O1 PLATE 1-15\n"
     "  tool T1 FACE MILL 3-5\n"
     "  tool T2 DRILL 8 6-15\n"
     "    cycle G81 8-11 +\n"
     "    cycle G81 12-12 +\n"
     "    cycle G83 13-15 +\n"
     "program O200 16-18\n"},
    {"ToolThatIsOnlyMadeReady", "fanuc", "T1 M6\nT2\nG1 X0\n(DRILL)\nM6\nT1\nG1 X5\nM6\n",
     "program  0-7\n"
     "  tool T1 0-2\n"
     "  tool T2 DRILL 3-6\n"
     "  tool T1 7-7\n"},
    {"Lathe", "fanuc-t", "O0007\nT0101\nG0 X50\nT0100\nT0303 (GROOVE)\nG75 X10 P2000\n",
     "program O7 0-5\n"
     "  tool T0101 1-3\n"
     "  tool T0303 GROOVE 4-5\n"
     "    cycle G75 5-5 +\n"},
    {"LinuxCnc", "linuxcnc", "(OUTER CONTOUR)\nT3 M6\nG1 X1\nG73 X0 Z-5 R1 Q1\nG80\no<pocket> sub\nG1 X5\no<pocket> endsub\nM2\n",
     "program  0-4\n"
     "  tool T3 OUTER CONTOUR 0-4\n"
     "    cycle G73 3-4 +\n"
     "subprogram O<pocket> 5-8\n"},
    {"Heidenhain", "heidenhain",
     "0 BEGIN PGM PLATE MM\n1 BLK FORM 0.1 Z X0 Y0 Z-20\n2 CYCL DEF 247 DATUM SETTING ~\n  Q339=+1 ;DATUM NUMBER\n3 * - Outline\n4 TOOL "
     "CALL 5 Z "
     "S2000\n5 LBL \"LEVEL\"\n6 L X5\n7 CALL LBL \"LEVEL\" REP 2\n8 TOOL CALL Z S1000\n9 * - Holes\n10 CYCL DEF 7.0 DATUM SHIFT\n11 CYCL "
     "DEF "
     "7.1 X+5\n12 TOOL DEF 7\n13 TOOL CALL \"DRILL_8\" Z\n14 LBL 1\n15 LBL 0\n16 END PGM PLATE MM\n",
     "program PLATE 0-17\n"
     "  cycle CYCL DEF 247 DATUM SETTING 2-3 +\n"
     "  tool T5 Outline 4-13\n"
     "    label LBL LEVEL 6-9\n"
     "    section Holes 10-10\n"
     "    cycle CYCL DEF 7.0 DATUM SHIFT 11-13 +\n"
     "  tool DRILL_8 14-17\n"
     "    label LBL 1 15-17\n"},
    {"Sinumerik", "sinumerik",
     "%_N_MAIN_MPF\nN10 G17\nMSG(\"SPOT\")\nT=\"SPOT_10\" M6\nMCALL CYCLE82(10, 0, 2, -2.5, , 0.3)\nCORNERS: HOLES1(-48, -28, 0, 0, 96, "
     "2)\nEND: "
     "STOPRE\nUNUSED: MCALL\nT2 M6\nREPEAT corners END\nCYCLE81(10,0,2,-16)\nCYCLE81(10,0,2,-18)\nM30\n%_N_PART_SPF\nM17\n",
     "program MAIN 0-12\n"
     "  tool SPOT_10 SPOT 2-7\n"
     "    cycle CYCLE82 4-4 +\n"
     "    label CORNERS 5-5\n"
     "    cycle HOLES1 5-7 +\n"
     "  tool T2 8-12\n"
     "    cycle CYCLE81 10-10 +\n"
     "    cycle CYCLE81 11-12 +\n"
     "program PART 13-14\n"},
    {"NothingToName", "grbl", "G1 X5 F100\n\nG0 X0\n", ""},
    {"Empty", "fanuc", "", ""},
};

INSTANTIATE_TEST_SUITE_P(Controls, Outline, testing::ValuesIn(cases), [](const auto& one) { return std::string(one.param.name); });

TEST(Outliner, StopsAtItsLimit) {
  const auto def = *load_control("fanuc");
  Outliner outliner(def);
  for (std::size_t n = 0; n < 2 * Outliner::max_entries; ++n) outliner.take(n, names_of_line(def, fmt::format("T{} M6", n % 90 + 1)));
  EXPECT_TRUE(outliner.full());
  const auto entries = outliner.finish(2 * Outliner::max_entries);
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].inside.size(), Outliner::max_entries - 1);
}

}  // namespace kadr::outline_test
