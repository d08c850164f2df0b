// The axes that are assumed for a machine that nobody has described: which words of a text name an axis, and which only look so.

#include "session/assumed_axes.h"

#include <gtest/gtest.h>

#include "config/control/control_file.h"

namespace kadr {
namespace {

std::string assumed(const char* control, const std::string& text, Setup setup = {}) {
  const auto def = load_control(control);
  EXPECT_TRUE(def);
  const auto source = text_source(text);
  assume_axes(setup, source.get(), *def);
  std::string axes;
  for (const std::string& name : setup.axes_assumed) axes += name;
  return axes;
}

TEST(AssumedAxes, WordsOfConversationalLines) {
  EXPECT_EQ(assumed("heidenhain", "0 BEGIN PGM T MM\n1 L X+1 A+30 R0 FMAX\n2 L IC-5 F100\n"), "AC");
  EXPECT_EQ(assumed("heidenhain", "L B+Q121 C+Q122 R0 FMAX\n"), "BC");
  EXPECT_EQ(assumed("heidenhain", "LN X+1 Y+2 Z+3 NX0 NY0 NZ1 A-1.5 C.5\n"), "AC");
}

TEST(AssumedAxes, OtherConversationalWordsAreNoAxes) {
  EXPECT_EQ(assumed("heidenhain", "; L A+30\n* - A+1 B+2\nL X+1 ; A+30\nPLANE SPATIAL SPA+1 SPB+2 SPC+3 STAY\nCYCL DEF 19.1 A+0 B+45\n"),
            "");
  EXPECT_EQ(assumed("heidenhain", "L X+1 Y+2 R0 FMAX M3\nCALL LBL 1\nLBL \"A+5\"\n"), "");
}

TEST(AssumedAxes, WordsOfBlocksWithNames) {
  EXPECT_EQ(assumed("sinumerik", "G0 X1 A30\nG1 C=DC(10) F100\n"), "AC");
  EXPECT_EQ(assumed("sinumerik", "G1 C=ACP(10) F100 B=AC(1)\n"), "BC");
  EXPECT_EQ(assumed("sinumerik", "N10G1X1B-5\n"), "B");
}

TEST(AssumedAxes, VariablesTextsAndCommentsAreNoAxes) {
  EXPECT_EQ(assumed("sinumerik", "DEF REAL A, B\nA=5\nB=7\n"), "");
  EXPECT_EQ(assumed("sinumerik", "PROC SUB(REAL A)\nA=5\n"), "");
  EXPECT_EQ(assumed("sinumerik", "; A30\nMSG(\"A30\")\nR1='HFF' R2='B1010'\nIF A==5 GOTOF C1\n$TC_DP1[1,1]=120\n"), "");
  EXPECT_EQ(assumed("sinumerik", "G1 X1 A3=0 B3=0.5 C3=1 F100\nC1: G1 X2\n"), "");
  EXPECT_EQ(assumed("sinumerik", "TRANS X10 W5\nN20 AROT A30\n"), "");
  EXPECT_EQ(assumed("sinumerik", "TRANSA1\nCYCLE81(10,0,2,-5)\nR[A]=5\n"), "");
}

TEST(AssumedAxes, TwoRotaryAxesGetTheUsualKinematics) {
  const auto kinematics = [](const std::string& text) {
    kadr::Setup setup;
    const auto source = text_source(text);
    assume_axes(setup, source.get(), *load_control("heidenhain"));
    return setup.kinematics.type + " " + setup.kinematics.axes + " " + setup.kinematics.reversed;
  };
  EXPECT_EQ(kinematics("L A+1 C+2\n"), "table-table AC AC");
  EXPECT_EQ(kinematics("L B+1 C+2\n"), "head-table BC C");
  EXPECT_EQ(kinematics("L C+2\n"), "  ");
}

TEST(AssumedAxes, ASetUpThatSaysWhatTheMachineIsDecides) {
  kadr::Setup named;
  named.axes = {"X", "Y", "Z", "B"};
  EXPECT_EQ(assumed("heidenhain", "L A+30\n", named), "");
  kadr::Setup kinematics;
  kinematics.kinematics.type = "table-table";
  EXPECT_EQ(assumed("heidenhain", "L A+30\n", kinematics), "");
  EXPECT_EQ(assumed("fanuc", "G0 A30\n"), "");
}

}  // namespace
}  // namespace kadr
