// config/setup/setup reads the set-up and the state of every golden case (JSON)
// and of every case of our own (in the text form of tests/cases/reader.py).

#include "case_files.h"
#include "config/setup/setup.h"

namespace kadr::setup_cases_test {
namespace {

using test::for_each_case;
using test::Json;
using test::setups_of;

void read_states(const Json& expect, const std::string& where) {
  if (expect.contains("state")) {
    Json state = expect["state"];
    state.erase("frame");  // not in a table: it follows from the codes in force
    const auto setup = parse_setup(state.dump());
    EXPECT_TRUE(setup) << where << ": " << setup.error();
  }
  for (const Json& step : expect.value("steps", Json::array())) read_states(step, where);
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
}  // namespace kadr::setup_cases_test
