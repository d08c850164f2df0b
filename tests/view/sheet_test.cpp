// The set-up sheet: what the set-up defines, what the program uses, and what its comments say.

#include "view/sheet.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "config/setup/setup_file.h"

namespace kadr::sheet_test {
namespace {

constexpr const char* program =
    "%\n"
    "O0007 (COVER <b>)\n"
    "(T1 = D16 ENDMILL, T3 = DRILL 6.8)\n"
    "(CLAMP AT THE EDGES)\n"
    "N10 G17 G21 G90 G94 G40\n"
    "(NOT A NOTE OF THE HEAD)\n"
    "N20 T1 M6\n"
    "N30 G54 G43 H1 G0 X0 Y0 Z50 S900 M3\n"
    "N40 G1 Z-5 F200\n"
    "N50 X100 G41 D11\n"
    "N60 Y50\n"
    "N65 G40 Y60\n"
    "N70 G0 Z50\n"
    "(TURN THE PART)\n"
    "N80 M0\n"
    "N90 T3 M6\n"
    "N100 G55 G43 H3 G0 X10 Y10 Z50\n"
    "N110 G1 Z-8 F100\n"
    "N120 G0 Z50\n"
    "N130 M1 (LOOK AT IT)\n"
    "N140 T1 M6\n"
    "N150 G0 Z60\n"
    "N160 M30\n"
    "%\n";

struct Made {
  std::unique_ptr<ProgramRun> run;
  std::unique_ptr<SourceText> source;
};

Made made_of(const std::string& text, const std::string& setup) {
  OpeningRequest request;
  request.path = "sheet_test.nc";
  request.control = "fanuc";
  request.text = text;
  auto opened = open_for_page(request);
  EXPECT_TRUE(opened) << opened.error();
  if (!setup.empty()) {
    auto read = read_setup({{"setup", setup}}, opened->def.get(), Lang::en);
    EXPECT_TRUE(read) << read.error();
    opened->setup = std::move(read->setup);
  }
  auto run = ProgramRun::make(*opened, {});
  EXPECT_TRUE(run);
  (*run)->execute();
  return {std::move(*run), std::make_unique<SourceText>(OpenedText{text_source(text), Encoding::utf8})};
}

constexpr const char* setup =
    R"({"work_offsets":{"G54":{"X":-400,"Y":-250,"Z":-300}},"offsets":{"1":{"length":120.5},"11":{"radius":8},"3":{"length":90,"length_wear":0.5}}})";

TEST(Sheet, HasTheZerosThatAreUsed) {
  const Made made = made_of(program, setup);
  const Sheet sheet = sheet_of(*made.run, *made.source, "cover.nc", Lang::en);
  ASSERT_EQ(sheet.zeros.size(), 2U);
  EXPECT_EQ(sheet.zeros[0].name, "G54");
  EXPECT_EQ(sheet.zeros[0].values, (AxisValues{{"X", -400}, {"Y", -250}, {"Z", -300}}));
  EXPECT_EQ(sheet.zeros[1].name, "G55");
  EXPECT_TRUE(sheet.zeros[1].values.empty());
}

TEST(Sheet, HasTheToolsWithTheirOffsets) {
  const Made made = made_of(program, setup);
  const Sheet sheet = sheet_of(*made.run, *made.source, "cover.nc", Lang::en);
  ASSERT_EQ(sheet.tools.size(), 2U);
  const Sheet::Tool &mill = sheet.tools[0], &drill = sheet.tools[1];
  EXPECT_EQ(mill.number, 1U);
  EXPECT_EQ(mill.radius, 8);
  EXPECT_EQ(mill.length, 120.5);
  EXPECT_EQ(mill.corrector, "H1 D11");
  EXPECT_EQ(mill.lines, (std::vector<std::uint32_t>{7, 21}));
  EXPECT_GT(mill.seconds, 0);
  EXPECT_FALSE(mill.outline.empty());
  EXPECT_EQ(drill.number, 3U);
  EXPECT_EQ(drill.length, 90.5);
  EXPECT_EQ(drill.corrector, "H3");
}

TEST(Sheet, TakesShapesFromAToolsFile) {
  const Made made = made_of(program, setup);
  ToolLibrary library;
  ToolGeometry ball;
  ball.number = 3, ball.name = "BALL 6", ball.kind = ToolKind::ball, ball.diameter = 6, ball.flutes = 20;
  library.tools.push_back(ball);
  const Sheet sheet = sheet_of(*made.run, *made.source, "cover.nc", Lang::en, &library);
  ASSERT_EQ(sheet.tools.size(), 2U);
  EXPECT_EQ(sheet.tools[1].name, "BALL 6");
  EXPECT_EQ(sheet.tools[1].radius, 3);
  EXPECT_EQ(sheet.tools[1].outline.back().height, 20);
}

TEST(Sheet, HasTheNotesAtTheHeadAndAtStops) {
  const Made made = made_of(program, setup);
  const Sheet sheet = sheet_of(*made.run, *made.source, "cover.nc", Lang::en);
  ASSERT_EQ(sheet.comments.size(), 3U);
  EXPECT_EQ(sheet.comments[0].text, "COVER <b>");
  EXPECT_EQ(sheet.comments[2].text, "CLAMP AT THE EDGES");
  EXPECT_EQ(sheet.comments[2].line, 4U);
  ASSERT_FALSE(sheet.stops.empty());
  EXPECT_EQ(sheet.stops[0].line, 15U);
  EXPECT_EQ(sheet.stops[0].text, "TURN THE PART");
  EXPECT_GT(sheet.stops[0].at, 0);
}

TEST(Sheet, OfAProgramThatDoesNothing) {
  const Made made = made_of("%\nO1\nM30\n%\n", "");
  const Sheet sheet = sheet_of(*made.run, *made.source, "empty.nc", Lang::ru);
  EXPECT_TRUE(sheet.tools.empty());
  EXPECT_TRUE(sheet.stops.empty());
  const auto json = sheet_json(sheet, made.run->statistics());
  EXPECT_TRUE(json["extents"]["cutting"].is_null());
  EXPECT_EQ(json["date"].get<std::string>().size(), 10U);
}

}  // namespace
}  // namespace kadr::sheet_test
