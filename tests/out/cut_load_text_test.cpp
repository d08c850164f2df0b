// Prints the material that blocks remove as text, JSON and CSV.

#include "out/text/cut_load_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace kadr::cut_load_text_test {
namespace {

BlockLoad slot() {
  BlockLoad load;
  load.origin.line = 12;
  load.origin.block = 110, load.origin.has_block = true, load.origin.block_digits = 4;
  load.tool = 3;
  load.begins = 1.25, load.seconds = 8, load.length = 40, load.volume = 1200;
  load.rate = 150, load.feed_per_tooth = 0.0625, load.depth = 3, load.width = 10, load.angle = 180;
  load.at = {30, 20, -3};
  return load;
}

BlockLoad plunge() {
  BlockLoad load;
  load.origin.line = 9;
  load.program = "sub,2.nc";
  load.tool = 1;
  load.seconds = 2, load.length = 4, load.volume = 10;
  load.rate = 5;
  return load;
}

TEST(cut_load_text, words) {
  EXPECT_EQ(load_words(slot(), Lang::en), "line 12 N0110 T3: 150.0 mm³/s, 0.0625 mm/tooth, 10.00 × 3.00 mm, 180°");
  EXPECT_EQ(load_words(slot(), Lang::ru), "строка 12 N0110 T3: 150.0 мм³/с, 0.0625 мм/зуб, 10.00 × 3.00 мм, 180°");
  EXPECT_EQ(load_words(plunge(), Lang::en), "line 9 of sub,2.nc T1: 5.0 mm³/s");
  EXPECT_EQ(load_words(plunge(), Lang::ru), "строка 9 файла sub,2.nc T1: 5.0 мм³/с");
  AirCut air;
  air.origin.line = 15, air.tool = 2, air.seconds = 72.34;
  EXPECT_EQ(air_words(air, Lang::en), "line 15 T2: 1:12.3");
}

TEST(cut_load_text, json) {
  CutResult result;
  result.heaviest = {slot(), plunge()};
  result.emptiest = {AirCut{slot().origin, {}, 3, 4.5}};
  nlohmann::ordered_json json;
  add_loads(json, result);
  EXPECT_EQ(
      json.dump(),
      R"({"heaviest":[{"line":12,"block":"N0110","tool":3,"rate":150.0,"feed_per_tooth":0.0625,"depth":3.0,"width":10.0,"angle":180.0,)"
      R"("volume":1200.0,"seconds":8.0,"at":{"X":30.0,"Y":20.0,"Z":-3.0},"at_time":1.25},)"
      R"({"line":9,"program":"sub,2.nc","tool":1,"rate":5.0,"feed_per_tooth":null,"depth":null,"width":null,"angle":null,)"
      R"("volume":10.0,"seconds":2.0,"at":{"X":0.0,"Y":0.0,"Z":0.0},"at_time":0.0}],)"
      R"("emptiest":[{"line":12,"block":"N0110","tool":3,"seconds":4.5}]})");
}

TEST(cut_load_text, calls) {
  const AlarmReport::Call calls[] = {{"O100", 4, 40, true, {}}, {"O200", 8, 0, false, "sub.nc"}};
  EXPECT_EQ(calls_json({calls[0], calls[1]}).dump(),
            R"([{"line":4,"block":"N40","program":"O100"},{"line":8,"program":"O200","file":"sub.nc"}])");
}

TEST(cut_load_text, csv) {
  EXPECT_EQ(blocks_heading(), "line,block,tool,begins,seconds,length,volume,rate,feed_per_tooth,depth,width,angle,program\n");
  EXPECT_EQ(blocks_row(slot()), "12,N0110,3,1.2500,8.0000,40.0000,1200.0000,150.000,0.06250,3.000,10.000,180.0,\n");
  EXPECT_EQ(blocks_row(plunge()), "9,,1,0.0000,2.0000,4.0000,10.0000,5.000,,,,,\"sub,2.nc\"\n");
}

}  // namespace
}  // namespace kadr::cut_load_text_test
