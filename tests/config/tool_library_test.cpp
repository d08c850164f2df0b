// Reads tools files in our own form and in those of other programs.

#include "config/tools/tool_library.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/tools/tool_formats.h"

namespace kadr::tool_library_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

ToolGeometry only(const tl::expected<ToolLibrary, std::string>& library) {
  EXPECT_TRUE(library) << library.error();
  EXPECT_THAT(library->tools, SizeIs(1));
  return library->tools.front();
}

std::string fault(const std::string& text) {
  const auto library = tools_of_toml(text, "tools.toml");
  EXPECT_FALSE(library);
  return library ? "" : library.error();
}

TEST(ToolLibrary, ReadsEveryKey) {
  const ToolGeometry t = only(tools_of_toml(R"([[tool]]
number = 3
name = "rougher"
kind = "bull"
diameter = 10
corner = 1.5
flute_length = 22
length = 60
shank = [[8, 22], [8, 60]]
holder = [[40, 0], [50, 30]]
plunges = false
flute_count = 4
)",
                                            "tools.toml"));
  EXPECT_EQ(t.number, 3u);
  EXPECT_EQ(t.name, "rougher");
  EXPECT_EQ(t.kind, ToolKind::bull);
  EXPECT_EQ(t.diameter, 10);
  EXPECT_EQ(t.corner, 1.5);
  EXPECT_EQ(t.flutes, 22);
  EXPECT_EQ(t.length, 60);
  EXPECT_EQ(t.shank, (std::vector<ProfilePoint>{{8, 22}, {8, 60}}));
  EXPECT_EQ(t.holder, (std::vector<ProfilePoint>{{40, 0}, {50, 30}}));
  EXPECT_FALSE(t.plunges);
  EXPECT_EQ(t.teeth, 4);
}

TEST(ToolLibrary, FlutesAndLengthFollowFromEachOther) {
  EXPECT_EQ(only(tools_of_toml("tool = [{number = 1, kind = \"flat\", diameter = 6, flute_length = 20}]", "t")).length, 20);
  EXPECT_EQ(only(tools_of_toml("tool = [{number = 1, kind = \"flat\", diameter = 6, length = 20}]", "t")).flutes, 20);
  const ToolGeometry form = only(tools_of_toml("tool = [{number = 1, kind = \"form\", profile = [[4, 0], [8, 5], [8, 9]]}]", "t"));
  EXPECT_EQ(form.flutes, 9);
  EXPECT_EQ(form.diameter, 8);
}

TEST(ToolLibrary, HeightsThatAreNotGivenAreThoseOfMost) {
  const auto flat = tools_of_toml("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 6\n", "t.toml");
  ASSERT_TRUE(flat) << flat.error();
  EXPECT_EQ(flat->tools[0].flutes, 18);
  EXPECT_EQ(flat->tools[0].length, 30);
  ASSERT_EQ(flat->notes.size(), 1U);
  EXPECT_THAT(flat->notes[0], HasSubstr("t.toml: T1: neither flute_length nor length is given"));
  EXPECT_EQ(only(tools_of_toml("tool = [{number = 1, kind = \"drill\", diameter = 6, angle = 118}]", "t")).length, 60);
  const auto half = tools_of_toml("tool = [{number = 1, kind = \"flat\", diameter = 6, length = 40}]", "t");
  EXPECT_TRUE(half->notes.empty());
}

TEST(ToolLibrary, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"flat\"\n"), HasSubstr("tools.toml:2:"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"flat\"\n"), HasSubstr("diameter is missing"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"mill\"\n"), HasSubstr("flat, ball, bull"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"drill\"\ndiameter = 6\nflutes = 20\n"), HasSubstr("118"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiametr = 6\n"), HasSubstr("'diameter'?"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"bull\"\ndiameter = 6\ncorner = 4\nflutes = 9\n"), HasSubstr("corner"));
  EXPECT_THAT(fault("[[tool]]\nnumber = -1\n"), HasSubstr("whole number"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 6\nflutes = 9\nteeth = 0\n"), HasSubstr("tools.toml:6:"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 6\nflutes = 9\nteeth = 2.5\n"), HasSubstr("whole number"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = nan\nflutes = 9\n"), HasSubstr("diameter"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"form\"\nprofile = [[4, 5], [8, 2]]\n"), HasSubstr("must not fall"));
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"form\"\nprofile = [[4, 5]]\n"), HasSubstr("two to 1000"));
  EXPECT_THAT(fault("tools = 3\n"), HasSubstr("[[tool]]"));
  EXPECT_THAT(fault(""), HasSubstr("[[tool]]"));
  const std::string one = "[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 6\nflutes = 9\n";
  EXPECT_THAT(fault(one + one), HasSubstr("twice"));
}

TEST(ToolLibrary, OldKeysAreReadWithANote) {
  const auto old = tools_of_toml("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 6\nflutes = 9\nteeth = 3\n", "old.toml");
  ASSERT_TRUE(old) << old.error();
  EXPECT_EQ(only(old).flutes, 9);
  EXPECT_EQ(only(old).teeth, 3);
  ASSERT_EQ(old->notes.size(), 2u);
  EXPECT_THAT(old->notes[0], HasSubstr("old.toml: flutes is called flute_length now"));
  EXPECT_THAT(old->notes[1], HasSubstr("teeth is called flute_count now"));
  const auto now = tools_of_toml("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 6\nflute_length = 9\nflute_count = 3\n", "new.toml");
  ASSERT_TRUE(now) << now.error();
  EXPECT_EQ(only(now).flutes, 9);
  EXPECT_EQ(only(now).teeth, 3);
  EXPECT_TRUE(now->notes.empty());
  EXPECT_THAT(fault("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 6\nflutes = 9\nflute_length = 9\n"), HasSubstr("they are the same"));
}

ToolGeometry turning(const std::string& keys) {
  return only(tools_of_toml("tool = [{number = 1, kind = \"turning\", " + keys + "}]", "t"));
}
std::string turning_fault(const std::string& keys) { return fault("tool = [{number = 1, kind = \"turning\", " + keys + "}]"); }

TEST(ToolLibrary, TurningToolsAreReadWithTheirTip) {
  const ToolGeometry t = only(tools_of_toml(R"([[tool]]
number = 7
kind = "turning"
points = "-x+z"
angle = 55
lead = 93
corner = 0.4
flute_length = 9
length = 11
holder = [[8, 1], [28, 60]]
)",
                                            "tools.toml"));
  EXPECT_EQ(t.kind, ToolKind::turning);
  EXPECT_EQ(t.insert.tip_x, -1);
  EXPECT_EQ(t.insert.tip_z, 1);
  EXPECT_EQ(t.insert.lead, 93);
  EXPECT_EQ(t.insert.holder, (std::vector<InsertPoint>{{8, 1}, {28, 60}}));
  EXPECT_EQ(t.length, 11);
}

TEST(ToolLibrary, ATurningToolStandsStraightIfNothingElseIsSaid) {
  EXPECT_EQ(turning("points = \"-x-z\", angle = 80, flute_length = 9").insert.lead, 95);
  EXPECT_EQ(turning("points = \"-x\", angle = 60, flute_length = 9").insert.lead, 60);
  EXPECT_EQ(turning("points = \"-z\", angle = 60, flute_length = 9").insert.lead, 150);
  EXPECT_EQ(turning("points = \"-x-z\", width = 3, flute_length = 9").insert.lead, 90);
  EXPECT_EQ(turning("points = \"-z\", width = 3, flute_length = 9").insert.lead, 0);
  EXPECT_EQ(turning("points = \"centre\", corner = 4").flutes, 8);
  EXPECT_THAT(turning("profile = [[0, 0], [5, 1], [5, 6]]").insert.profile, SizeIs(3));
}

TEST(ToolLibrary, SaysWhatIsWrongWithATurningTool) {
  EXPECT_THAT(turning_fault("angle = 80, flute_length = 9"), HasSubstr("-x-z"));
  EXPECT_THAT(turning_fault("points = \"3\", angle = 80, flute_length = 9"), HasSubstr("points"));
  EXPECT_THAT(turning_fault("points = \"-x\", flute_length = 9"), HasSubstr("angle is missing"));
  EXPECT_THAT(turning_fault("points = \"-x\", angle = 60"), HasSubstr("flute_length is missing"));
  EXPECT_THAT(turning_fault("points = \"-x\", angle = 60, flute_length = 2, corner = 1"), HasSubstr("too short"));
  EXPECT_THAT(turning_fault("points = \"-x\", width = 1, flute_length = 5, corner = 1"), HasSubstr("half of the width"));
  EXPECT_THAT(turning_fault("points = \"-x\", width = 1, flute_length = 5, lead = 45"), HasSubstr("90"));
  EXPECT_THAT(turning_fault("points = \"-x\", angle = 60, flute_length = 9, holder = [[1, 2]]"), HasSubstr("2 (a rectangle"));
  EXPECT_THAT(turning_fault("profile = [[0, 0], [5, 5], [5, 0], [0, 5]]"), HasSubstr("crosses itself"));
  EXPECT_THAT(turning_fault("profile = [[0, 0], [5, 5], [9, 9]]"), HasSubstr("no area"));
}

TEST(ToolFormats, LinuxcncTableOfALathe) {
  const auto library =
      tools_of_linuxcnc("T1 P1 D0.8 I+85 J+25 Q2 ;rough\nT2 P2 D0.8 Q2\nT3 P3 D4 I0 J0 Q9\nT4 P4 I85 J25 Q2\n", "lathe.tbl");
  ASSERT_TRUE(library);
  ASSERT_THAT(library->tools, SizeIs(4));
  EXPECT_EQ(library->tools[0].kind, ToolKind::turning);
  EXPECT_EQ(library->tools[0].corner, 0.4);
  EXPECT_EQ(library->tools[1].kind, ToolKind::flat);  // a table without I and J does not describe an insert
  EXPECT_EQ(library->tools[2].angle, 0);
  EXPECT_EQ(library->tools[3].corner, 0);
  EXPECT_THAT(library->notes, SizeIs(2));
}

// The sizes of the table are in the unit of the program, here inches.
TEST(ToolFormats, LinuxcncTableOfAMachineInInches) {
  auto library = tools_of_linuxcnc("T1 P1 D+0.5\nT2 P2 D0.8 I+85 J+25 Q2\nT3 P3 D0.25 I0 J0 Q9\n", "tool.tbl");
  ASSERT_TRUE(library);
  take_unit(25.4, *library);
  EXPECT_DOUBLE_EQ(library->tools[0].diameter, 12.7);
  EXPECT_EQ(library->tools[0].length, 100);  // an assumed length, mm
  EXPECT_DOUBLE_EQ(library->tools[1].corner, 10.16);
  EXPECT_GE(library->tools[1].flutes, 3 * 10.16);
  EXPECT_DOUBLE_EQ(library->tools[2].corner, 3.175);
  take_unit(25.4, *library);  // the library is in mm now
  EXPECT_DOUBLE_EQ(library->tools[0].diameter, 12.7);
}

TEST(ToolFormats, OwnToolsAreInMillimetres) {
  auto library = tools_of_toml("[[tool]]\nnumber = 1\nkind = \"flat\"\ndiameter = 10\nflutes = 20\n", "a.toml");
  ASSERT_TRUE(library);
  take_unit(25.4, *library);
  EXPECT_EQ(library->tools[0].diameter, 10);
}

TEST(ToolFormats, ATaperedMillOfFusionHasItsDiameterAtTheTip) {
  const auto fusion = [](const char* corner) {
    return fmt::format(
        R"({{"data":[{{"type":"tapered mill","unit":"millimeters","geometry":{{"DC":4,"RE":{},"TA":10,"LCF":15,"LB":50}},)"
        R"("post-process":{{"number":5}}}},{{"type":"flat end mill","unit":"millimeters","geometry":{{"DC":6,"LCF":9}}}}]}})",
        corner);
  };
  const auto library = tools_of_fusion(fusion("0"), "tools.json");
  ASSERT_TRUE(library);
  ASSERT_THAT(library->tools, SizeIs(2));
  EXPECT_EQ(library->tools[0].kind, ToolKind::taper);
  EXPECT_NEAR(library->tools[0].diameter - 2 * 15 * 0.17632698, 4, 1e-6);
  EXPECT_THAT(tools_of_fusion(fusion("1"), "tools.json")->tools, SizeIs(1));  // the other tool is left out, with a message
}

TEST(ToolFormats, AreToldByNameAndText) {
  EXPECT_EQ(tool_format_of("T1 D3", "a.tbl"), ToolFormat::linuxcnc);
  EXPECT_EQ(tool_format_of("[[tool]]", "a.toml"), ToolFormat::toml);
  EXPECT_EQ(tool_format_of("{\"tools\": {}}", "a.camotics"), ToolFormat::camotics);
  EXPECT_EQ(tool_format_of("{\"shape\": \"endmill.fcstd\"}", "a.json"), ToolFormat::freecad);
  EXPECT_EQ(tool_format_of("{\"data\": [{\"geometry\": {}}]}", "a.json"), ToolFormat::fusion);
}

TEST(ToolFormats, LinuxcncTableSaysWhatIsAssumed) {
  const auto library =
      tools_of_linuxcnc("; a table\nT1 P1 Z0.5 D+6.35 ;1/4 ball nose\nT2 P2 Z1 ; no diameter\nT12 P3 D3 ; DRILL\n", "tool.tbl");
  ASSERT_TRUE(library);
  ASSERT_THAT(library->tools, SizeIs(2));
  EXPECT_EQ(library->tools[0].kind, ToolKind::ball);
  EXPECT_EQ(library->tools[0].diameter, 6.35);
  EXPECT_EQ(library->tools[1].number, 12u);
  EXPECT_EQ(library->tools[1].kind, ToolKind::drill);
  EXPECT_THAT(library->notes, SizeIs(2));
  EXPECT_FALSE(tools_of_linuxcnc("T1 P1\n", "tool.tbl"));
}

TEST(ToolFormats, CamoticsProject) {
  const auto library = tools_of_camotics(R"({"units": "metric", "tools": {
    "1": {"units": "metric", "shape": "Cylindrical", "length": 20, "diameter": 6, "description": "end mill"},
    "2": {"units": "imperial", "shape": "ballnose", "length": 1, "diameter": 0.25},
    "3": {"units": "metric", "shape": "conical", "length": 5, "diameter": 10},
    "4": {"units": "metric", "shape": "saw", "length": 5, "diameter": 10}}})",
                                         "job.camotics");
  ASSERT_TRUE(library);
  ASSERT_THAT(library->tools, SizeIs(3));
  EXPECT_EQ(library->find(2)->diameter, 6.35);
  EXPECT_NEAR(library->find(3)->angle, 90, 1e-9);
  EXPECT_THAT(library->notes, SizeIs(1));
}

TEST(ToolFormats, FreecadBitIsWhateverTheProgramCalls) {
  const auto library = tools_of_freecad(R"({"version": 2, "name": "5mm", "shape": "endmill.fcstd",
    "parameter": {"CuttingEdgeHeight": "30.0000 mm", "Diameter": "0.2500 in", "Length": "50.0000 mm", "ShankDiameter": "3.0000 mm", "Flutes": "2"}})",
                                        "5mm.fctb");
  ASSERT_TRUE(library);
  ASSERT_NE(library->find(7), nullptr);
  EXPECT_NEAR(library->find(7)->diameter, 6.35, 1e-12);
  EXPECT_EQ(library->find(7)->teeth, 2);
  EXPECT_EQ(library->find(7)->shank, (std::vector<ProfilePoint>{{3, 30}, {3, 50}}));
}

TEST(ToolFormats, FusionLibraryWithHolder) {
  const auto library = tools_of_fusion(R"({"version": 1, "data": [
    {"type": "holder", "segments": []},
    {"type": "bull nose end mill", "unit": "millimeters", "description": "x", "post-process": {"number": 4},
     "geometry": {"DC": 10, "RE": 1, "LCF": 22, "LB": 40, "SFDM": 10, "NOF": 3},
     "holder": {"segments": [{"height": 20, "lower-diameter": 30, "upper-diameter": 40}]}},
    {"type": "tap right hand", "unit": "millimeters", "post-process": {"number": 5}, "geometry": {"DC": 6}}]})",
                                       "lib.json");
  ASSERT_TRUE(library);
  const ToolGeometry* const t = library->find(4);
  ASSERT_NE(t, nullptr);
  EXPECT_EQ(t->corner, 1);
  EXPECT_EQ(t->length, 40);
  EXPECT_EQ(t->teeth, 3);
  EXPECT_EQ(t->holder, (std::vector<ProfilePoint>{{30, 0}, {40, 20}}));
  EXPECT_THAT(library->notes, SizeIs(1));
}

TEST(ToolFormats, GarbageIsRefused) {
  for (const char* text :
       {"", "{", "[]", "{}", "{\"tools\": []}", "{\"tools\": {\"1\": 3}}", "{\"data\": {\"a\": 1}}", "{\"parameter\": 1, \"shape\": 2}"}) {
    EXPECT_FALSE(tools_of_camotics(text, "f")) << text;
    EXPECT_FALSE(tools_of_freecad(text, "f")) << text;
    EXPECT_FALSE(tools_of_fusion(text, "f")) << text;
  }
}

}  // namespace
}  // namespace kadr::tool_library_test
