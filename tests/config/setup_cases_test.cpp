// config/setup reads the set-up and the state of every golden case and every case of our own.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "config/setup.h"

namespace kadr {
namespace {

using Json = nlohmann::json;

/// Set-ups of a case: its own, or one a variant, whose keys replace the case's (in `parameters` each parameter).
std::vector<Json> setups_of(const Json& given) {
  if (!given.contains("variants")) return {given["setup"]};
  std::vector<Json> setups;
  for (const Json& variant : given["variants"]) {
    Json setup = given["setup"];
    const Json changed = variant.value("setup", Json::object());
    for (const auto& [key, value] : changed.items()) {
      if (key == "parameters") setup[key].update(value);
      else setup[key] = value;
    }
    setups.push_back(setup);
  }
  return setups;
}

void read_states(const Json& expect, const std::string& where) {
  if (expect.contains("state")) {
    Json state = expect["state"];
    state.erase("frame");  // no table: it follows from the codes in force
    const auto setup = parse_setup(state.dump());
    EXPECT_TRUE(setup) << where << ": " << setup.error();
  }
  for (const Json& step : expect.value("steps", Json::array())) read_states(step, where);
}

void for_each_case(const std::function<void(const Json&, const std::string&)>& use) {
  namespace fs = std::filesystem;
  std::size_t count = 0;
  for (const char* const folder : {"/tests/golden", "/tests/cases"})
    for (const auto& entry : fs::recursive_directory_iterator(KADR_ROOT + std::string(folder))) {
      if (entry.path().extension() != ".json" || entry.path().filename() == "schema.json") continue;
      std::ifstream stream(entry.path());
      use(Json::parse(stream), entry.path().filename());
      ++count;
    }
  EXPECT_GT(count, 0U);
}

TEST(setup_cases, every_setup) {
  for_each_case([](const Json& given, const std::string& where) {
    for (const Json& setup : setups_of(given)) {
      const auto read = parse_setup(setup.dump());
      EXPECT_TRUE(read) << where << ": " << read.error();
    }
  });
}

TEST(setup_cases, every_state) {
  for_each_case([](const Json& given, const std::string& where) {
    read_states(given["expect"], where);
    for (const Json& variant : given.value("variants", Json::array())) read_states(variant.value("expect", Json::object()), where);
  });
}

}  // namespace
}  // namespace kadr
