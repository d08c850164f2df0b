// Proposes tools from files, from the set-up and from comments.

#include "view/proposals.h"

#include <gtest/gtest.h>

#include "config/tools/tool_list.h"

namespace kadr::proposals_test {
namespace {

std::unique_ptr<ProgramRun> run_of(const std::string& program, const std::string& control = "mach3") {
  OpeningRequest request;
  request.path = "proposals_test.nc";
  request.control = control;
  request.text = program;
  auto opened = open_for_page(request);
  EXPECT_TRUE(opened) << opened.error();
  opened->setup.offsets[5].radius = 3;
  auto run = ProgramRun::make(*opened, {});
  EXPECT_TRUE(run);
  (*run)->execute();
  return std::move(*run);
}

constexpr const char* text =
    "(T1 D10 ENDMILL)\n"
    "G21 G90 G17\n"
    "T1 M6\n"
    "S1000 M3\n"
    "G1 X10 F100\n"
    "T2 M6 (DRILL 6.8)\n"
    "G1 X20 F100\n"
    "T5 M6\n"
    "G41 D5 G1 X30 F100\n"
    "G40 G1 X50\n"
    "T9 M6\n"
    "M30\n";

TEST(Proposals, OfEachToolThatCuts) {
  const auto run = run_of(text);
  EXPECT_EQ(tools_cutting(*run), (std::vector<std::uint32_t>{1, 2, 5}));
  const auto tools = proposed_tools(*run, nullptr);
  ASSERT_EQ(tools.size(), 3U);
  EXPECT_TRUE(tools[0].known);
  EXPECT_EQ(tools[0].tool.kind, ToolKind::flat);
  EXPECT_EQ(tools[0].tool.diameter, 10);
  EXPECT_NE(tools[0].from.find("line 1"), std::string::npos) << tools[0].from;
  EXPECT_TRUE(tools[1].known);
  EXPECT_EQ(tools[1].tool.kind, ToolKind::drill);
  EXPECT_EQ(tools[1].tool.angle, 118);
  EXPECT_FALSE(tools[2].known) << "its kind is not";
  EXPECT_EQ(tools[2].tool.diameter, 6) << tools[2].from;
  for (const ProposedTool& t : tools)
    if (t.known) {
      EXPECT_EQ(tool_fault_message(t.tool), "");
    }
}

// A Fanuc control is back in millimetres after M30; the sizes in the comments are in inches all the same.
TEST(Proposals, OfAProgramInInches) {
  const auto run = run_of(
      "(T2 D=0.842 CR=0. - FLAT END MILL)\n"
      "(TOOL 4 = 3/8IN ENDMILL)\n"
      "(T3 1/4-20 TAP DRILL #7)\n"
      "(T7 6. FLAT ENDMILL)\n"
      "G20 G90\n"
      "T2 M6\nG1 X1. F10.\n"
      "T4 M6\nG1 X2.\n"
      "T3 M6\nG1 X3.\n"
      "T7 M6\nG1 X4.\n"
      "M30\n",
      "fanuc");
  const auto tools = proposed_tools(*run, nullptr);
  ASSERT_EQ(tools.size(), 4U);
  EXPECT_NEAR(tools[0].tool.diameter, 21.3868, 1e-9);
  EXPECT_NEAR(tools[1].tool.diameter, 9.525, 1e-9);
  EXPECT_NEAR(tools[2].tool.diameter, 5.1054, 1e-9);
  EXPECT_FALSE(tools[3].known) << "six inches, or six millimetres";
  EXPECT_EQ(tools[3].from, "not sure: line 4 \"T7 6. FLAT ENDMILL\"") << "nothing is proposed, and it is said why";
  EXPECT_EQ(tools[3].tool.diameter, 0);
}

TEST(Proposals, OfAProgramThatCallsNone) {
  const auto run = run_of("G21 G90\nG1 X10 F100\nM30\n");
  const auto tools = proposed_tools(*run, nullptr);
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0].tool.number, 0U);
  EXPECT_FALSE(tools[0].known);
}

TEST(Proposals, AFileThatDescribesAllOfThem) {
  const auto run = run_of(text);
  const auto library = [](std::initializer_list<int> numbers) {
    ToolLibrary made;
    for (const int n : numbers) {
      ToolGeometry tool;
      tool.number = std::uint32_t(n), tool.diameter = 4, tool.flutes = 9, tool.length = 20;
      made.tools.push_back(tool);
    }
    return made;
  };
  const KnownTools part{"a.toml", library({1, 2})}, all{"b.toml", library({1, 2, 5, 7})}, own{"proposals_test.toml", library({5, 2, 1})};
  EXPECT_EQ(tools_file_for({part}, *run), nullptr);
  const std::vector<KnownTools> two{part, all};
  EXPECT_EQ(tools_file_for(two, *run), &two[1]);
  const std::vector<KnownTools> like{all, {"c.toml", all.tools}};
  EXPECT_EQ(tools_file_for(like, *run), nullptr) << "nobody knows which";
  const std::vector<KnownTools> named{all, own};
  EXPECT_EQ(tools_file_for(named, *run), &named[1]) << "called as the program";
  const auto tools = proposed_tools(*run, &part);
  ASSERT_EQ(tools.size(), 3U);
  EXPECT_EQ(tools[0].from, "a.toml");
  EXPECT_TRUE(tools[0].known);
  EXPECT_EQ(tools[0].tool.diameter, 4);
  EXPECT_FALSE(tools[2].known);
}

TEST(Proposals, WhatTurns) {
  EXPECT_TRUE(is_turning(*run_of("G18\nG1 X10 F100\nM2\n", "linuxcnc")));
  EXPECT_FALSE(is_turning(*run_of("G17\nG1 X10 F100\nM2\n", "linuxcnc")));
}

}  // namespace
}  // namespace kadr::proposals_test
