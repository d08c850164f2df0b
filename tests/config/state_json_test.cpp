// config/state/state_json: the state after a run, as in `state` of tests/golden/README.md.

#include "config/state/state_json.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "config/random_setup.h"

namespace kadr::state_json_test {
namespace {

TEST(state_json, empty) { EXPECT_EQ(state_json({}), R"({"tool":0})"); }

// The forms that cases 15-2, 10-14, 24-1 and 12-17 of nct expect.
TEST(state_json, tables) {
  RunState state;
  kadr::Setup& t = state.tables;
  t.offsets[4] = {};
  t.offsets[5] = {12.5, 5, 0.1, -0.02, 0.8, 0};
  t.work_offsets["G54.1 P2"] = {{"X", 50}, {"G17", 10.5}};
  t.parameters[{"0107", "4", "0"}] = 1.0;
  t.parameters[{"605", "1", ""}] = std::string("1");
  t.place_table[{10, 1}] = 0;
  t.form_table[5] = {4, 1, 0, 0, 0};
  t.skip = {8};
  EXPECT_EQ(
      state_json(state),
      R"({"offsets":{"5":{"length":12.5,"length_wear":0.1,"radius":5,"radius_wear":-0.02,"corner_radius":0.8,"corner_radius_wear":0}},)"
      R"("work_offsets":{"G54.1 P2":{"G17":10.5,"X":50}},"parameters":{"N0107.4#0":1,"N0605.1":"1"},"tool":0,)"
      R"("place_table":{"10/1":0},"form_table":{"5":{"left":4,"right":1,"up":0,"down":0,"geometry":0}},"skip":[8]})");
}

TEST(state_json, shifts_plane_diameter) {
  RunState state;
  state.shifts["G52"] = {{"X", 0}, {"Y", -0.0}};
  state.tables.plane = "XV";
  state.tables.diameter = {{"X", false}};
  state.tables.tool = 12;
  EXPECT_EQ(state_json(state), R"({"shifts":{"G52":{"X":0,"Y":0}},"plane":"XV","diameter":{"X":false},"tool":12})");
}

TEST(state_json, spindles) {
  RunState state;
  state.tables.spindles[1].rpm = 500;  // set before the run
  state.tables.spindles[1].ranges = {{50, 1000}};
  state.tables.spindles[2].name = "S2";
  state.spindles[1] = {"closed", 318.25, "cw", 100, 4, 0, 90.0};
  EXPECT_EQ(state_json(state),
            R"({"spindle":{"1":{"ranges":[[50,1000]],"rpm":318.25,"dir":"cw","loop":"closed","surface_speed":100,"css_axis":4,)"
            R"("master":null,"angle":90},"2":{"name":"S2","rpm":0,"dir":"stop","loop":"open","surface_speed":0,"css_axis":0,)"
            R"("master":null}},"tool":0})");
}

TEST(state_json, tool_rows) {
  RunState state;
  state.tables.tool_table[2].type = 81501070;
  state.tables.tool_table[2].info = 17;
  state.tables.tool_table[3].info = 33;
  state.tables.tool_table[3].user = {0, 2.5};
  EXPECT_EQ(state_json(state),
            R"({"tool":0,"tool_table":{"2":{"T":81501070,"info":"SENCV","form":0,"status":0,"counter":0,"life":0,"warn":0,"H":0,"D":0,)"
            R"("G":0,"W":0,"S":0,"F":0},"3":{"T":0,"info":33,"form":0,"status":0,"counter":0,"life":0,"warn":0,"H":0,"D":0,"G":0,"W":0,)"
            R"("S":0,"F":0,"user":[0,2.5]}}})");
}

TEST(state_json, numbers_read_back) {
  RunState state;
  for (const double value : {0.1 + 0.2, 999999999.9, 5e-324, 123456789.125, 1e9, std::numeric_limits<double>::infinity()}) {
    state.tables.feed = value;
    const auto read = parse_setup(state_json(state));
    ASSERT_TRUE(read) << read.error();
    if (std::isfinite(value)) EXPECT_EQ(read->feed, value);
    else EXPECT_EQ(read->feed, std::nullopt);
  }
}

RC_GTEST_PROP(state_json, reads_back, ()) {
  RunState state;
  state.tables = test::any_tables();
  state.tables.plane = *rc::gen::element<std::string>("", "XY", "XC");
  state.tables.diameter[test::any_axis()] = *rc::gen::arbitrary<bool>();
  state.tables.tool = test::any_row();
  state.tables.skip = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 9));
  state.shifts["G92"] = test::any_axes();
  state.spindles[2] = {"closed", test::any_count() / 1000, "ccw", test::any_count() / 1000, 3, *rc::gen::inRange(0, 2), test::any_number()};
  const auto read = parse_setup(state_json(state));
  if (!read) RC_FAIL(read.error());
  RC_ASSERT(read->offsets == state.tables.offsets);
  RC_ASSERT(read->work_offsets == state.tables.work_offsets);
  RC_ASSERT(read->parameters == state.tables.parameters);
  RC_ASSERT(read->tool_table == state.tables.tool_table);
  RC_ASSERT(read->place_table == state.tables.place_table);
  RC_ASSERT(read->form_table == state.tables.form_table);
  RC_ASSERT(read->plane == state.tables.plane);
  RC_ASSERT(read->diameter == state.tables.diameter);
  RC_ASSERT(read->tool == state.tables.tool);
  RC_ASSERT(read->skip == state.tables.skip);
  RC_ASSERT(read->shifts == state.shifts);
  RC_ASSERT(read->spindles.at(2).rpm == state.spindles.at(2).rpm);
  RC_ASSERT(read->spindles.at(2).loop == "closed");
  RC_ASSERT(read->spindles.at(2).master == state.spindles.at(2).master);
  RC_ASSERT(read->spindles.at(2).angle == state.spindles.at(2).angle);
  RC_ASSERT(state_json({*read, state.shifts, state.spindles}) == state_json(state));
}

}  // namespace
}  // namespace kadr::state_json_test
