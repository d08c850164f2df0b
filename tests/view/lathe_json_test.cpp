// What the panel of a lathe shows: diameters, the speed of the spindle with G96, feed per revolution, the row of the offsets. On a lathe's
// control, and on a mill's.

#include "view/lathe_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "view/instant.h"

namespace kadr::lathe_json_test {
namespace {

PageJson state_of(const std::string& program, const std::string& control, std::uint32_t block) {
  OpeningRequest request;
  request.path = "lathe_json_test.nc";
  request.control = control;
  request.text = program;
  auto made = open_for_page(request);
  EXPECT_TRUE(made) << made.error();
  auto run = ProgramRun::make(*made, {});
  EXPECT_TRUE(run) << run.error();
  (*run)->execute();
  const auto state = Instants(**run).after(block, {});
  EXPECT_TRUE(state) << state.error();
  return state_json(*state, **run);
}

constexpr const char* lathe =
    "O1\n"
    "G10 P10001 X-40. Z-20. R0.8 Q3\n"
    "T0101\n"
    "G50 S2000\n"
    "G96 S200 M3\n"
    "G0 X100. Z5.\n"
    "G1 X20. F0.3\n"
    "G97 S700\n"
    "M30\n";

TEST(LatheJson, TellsWhatALatheShows) {
  const PageJson state = state_of(lathe, "fanuc-t", 6);
  EXPECT_EQ(state["diameters"], PageJson::array({"X"}));
  EXPECT_EQ(state["surface"]["speed"], 200);
  EXPECT_EQ(state["surface"]["most"], 2000);
  EXPECT_NEAR(state["rpm"].get<double>(), 1000 * 200 / (std::numbers::pi * 100), 1e-6);
  EXPECT_EQ(state["tool_offset"]["row"], 1);
  EXPECT_EQ(state["tool_offset"]["geometry"]["X"], -20) << "G10 states a diameter, the page gets the true length";
  EXPECT_EQ(state["tool_offset"]["geometry"]["Z"], -20);
  EXPECT_EQ(state["tool_offset"]["radius"], 0.8);
  EXPECT_EQ(state["tool_offset"]["tip"], 3);
}

TEST(LatheJson, TheSpindleIsLimited) {
  const PageJson state = state_of(lathe, "fanuc-t", 7);
  EXPECT_EQ(state["rpm"], 2000) << "3183 without the limit";
  EXPECT_EQ(state["feed_per_turn"], 0.3);
  const PageJson without = state_of(lathe, "fanuc-t", 8);
  EXPECT_TRUE(without["surface"].is_null());
  EXPECT_EQ(without["rpm"], 700);
}

TEST(LatheJson, AMillHasNothingOfIt) {
  const PageJson state = state_of("O1\nG21 G90 G54\nT1 M6\nG43 H1 Z5.\nG1 X20. F300\nM30\n", "fanuc", 5);
  EXPECT_EQ(state["diameters"], PageJson::array());
  for (const char* const key : {"surface", "feed_per_turn", "tool_offset"}) EXPECT_TRUE(state[key].is_null()) << key;
}

TEST(LatheJson, AtTheAxisNothingLimitsTheSpeed) {
  LatheModes modes;
  modes.diameters = 2;
  modes.surface = {true, 1, 0, 150};
  PageJson json = {{"rpm", 0}};
  put_lathe(json, modes, {"Z", "X"}, {}, 0, true);
  EXPECT_TRUE(json["rpm"].is_null());
  EXPECT_EQ(json["diameters"], PageJson::array({"X"}));
  put_lathe(json, modes, {"Z", "X"}, {}, 4000, true);
  EXPECT_EQ(json["rpm"], 4000) << "the machine's spindle";
}

}  // namespace
}  // namespace kadr::lathe_json_test
