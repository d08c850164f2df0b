// Tools as a JSON list: they give the same tools as a file, and the same refusals.

#include "config/tools/tool_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "config/read_file.h"

namespace kadr::tool_list_test {
namespace {

using testing::HasSubstr;

std::string fault(const std::string& json) {
  const auto library = tools_of_list(json);
  EXPECT_FALSE(library) << json;
  return library ? "" : library.error();
}

TEST(ToolList, IsAsTheFile) {
  for (const char* name : {"/examples/cut/tools.toml", "/examples/cut/turned.toml", "/examples/cut/five_axes.toml"}) {
    const auto file = load_tools(KADR_ROOT + std::string(name));
    ASSERT_TRUE(file) << file.error();
    auto list = nlohmann::ordered_json::array();
    for (const ToolGeometry& tool : file->tools) list.push_back(tool_json(tool));
    const auto again = tools_of_list(list.dump());
    ASSERT_TRUE(again) << again.error();
    ASSERT_EQ(again->tools.size(), file->tools.size());
    for (std::size_t i = 0; i < file->tools.size(); ++i) {
      const ToolGeometry &a = file->tools[i], &b = again->tools[i];
      EXPECT_EQ(a.number, b.number);
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.kind, b.kind);
      for (const auto member : {&ToolGeometry::diameter, &ToolGeometry::corner, &ToolGeometry::angle, &ToolGeometry::tip,
                                &ToolGeometry::flutes, &ToolGeometry::length})
        EXPECT_EQ(a.*member, b.*member) << a.number;
      for (const auto member : {&ToolGeometry::profile, &ToolGeometry::shank, &ToolGeometry::holder}) EXPECT_EQ(a.*member, b.*member);
      EXPECT_EQ(a.plunges, b.plunges);
      EXPECT_EQ(a.teeth, b.teeth);
      EXPECT_EQ(a.insert.tip_x, b.insert.tip_x);
      EXPECT_EQ(a.insert.tip_z, b.insert.tip_z);
      EXPECT_EQ(a.insert.lead, b.insert.lead);
      EXPECT_EQ(a.insert.width, b.insert.width);
      EXPECT_EQ(a.insert.profile, b.insert.profile);
      EXPECT_EQ(a.insert.holder, b.insert.holder);
    }
  }
}

TEST(ToolList, WholeNumbersMayBeSizes) {
  const auto library = tools_of_list(R"([{"number": 7, "kind": "flat", "diameter": 10, "flutes": 20.5, "length": null}])");
  ASSERT_TRUE(library) << library.error();
  EXPECT_EQ(library->tools.front().number, 7U);
  EXPECT_EQ(library->tools.front().length, 20.5);
}

TEST(ToolList, WhatIsWrongNamesTheTool) {
  EXPECT_THAT(fault(R"([{"number": 3, "kind": "flat", "flutes": 5}])"), HasSubstr("T3: tool 3: diameter is missing"));
  EXPECT_THAT(fault(R"([{"kind": "flat", "diameter": 5}])"), HasSubstr("tool no. 1: number"));
  EXPECT_THAT(fault(R"([{"number": 3, "kind": "spoon", "diameter": 5}])"), HasSubstr("T3: kind must be"));
  EXPECT_THAT(fault(R"([{"number": 3, "kind": "flat", "diameter": 1e300, "flutes": 5}])"), HasSubstr("T3: diameter must be"));
  EXPECT_THAT(fault(R"([{"number": 3, "kind": "flat", "diameter": -1, "flutes": 5}])"), HasSubstr("T3: diameter must be"));
  EXPECT_THAT(fault(R"([{"number": 3, "kind": "flat", "diameter": "5", "flutes": 5}])"), HasSubstr("T3: diameter must be"));
  EXPECT_THAT(fault(R"([{"number": 3, "kind": "flat", "diametre": 5, "flutes": 5}])"), HasSubstr("'diameter'?"));
  EXPECT_THAT(fault(R"([{"number": 1e30, "kind": "flat", "diameter": 5, "flutes": 5}])"), HasSubstr("number"));
  EXPECT_THAT(fault(R"([{"number": 18446744073709551615, "kind": "flat", "diameter": 5, "flutes": 5}])"), HasSubstr("number"));
  const std::string one = R"({"number": 3, "kind": "flat", "diameter": 5, "flutes": 5})";
  EXPECT_THAT(fault("[" + one + "," + one + "]"), HasSubstr("tool 3 stands twice"));
}

TEST(ToolList, WhatIsNoList) {
  for (const char* text : {"", "[]", "{}", "7", "null", "[7]", "[[]]", "[{}]", "[", R"([{"number": 1, "number": 2}])"}) (void)fault(text);
}

}  // namespace
}  // namespace kadr::tool_list_test
