// config/setup reads the set-up and the state of every golden case (JSON) and every case of our own (the text of tests/cases/reader.py).

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

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

/// The lines of a text of cases; `| ` continues the line before it.
std::vector<std::string> lines_of(std::istream& stream) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("| ") && !lines.empty()) lines.back() += line.substr(1);
    else lines.push_back(line);
  }
  return lines;
}

/// Of a text of cases what set-ups and states are made of, in the form of the golden cases.
std::vector<Json> cases_of(const std::vector<std::string>& lines) {
  const Json empty = {{"setup", Json::object()}, {"expect", Json::object()}};
  std::vector<Json> cases;
  Json* part = nullptr;  // the case or the variant that is read
  Json* text = nullptr;  // the file or the program of a channel that is read
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.starts_with("    ")) {
      if (text) *text = text->is_null() ? line.substr(4) : text->get<std::string>() + "\n" + line.substr(4);
      continue;
    }
    text = nullptr;
    const std::string key = line.substr(0, line.find(' '));
    const std::string rest = line.substr(std::min(line.size(), key.size() + 1));
    if (key == "==") {
      part = &cases.emplace_back(empty);
      (*part)["id"] = rest.substr(0, rest.find(" |"));
      ++i;  // the title
    } else if (key == "--") {
      part = &cases.back()["variants"].emplace_back(empty);
    } else if (key == "setup") {
      (*part)["setup"] = Json::parse(rest);
    } else if (key == "state" || key == "steps") {
      (*part)["expect"][key] = Json::parse(rest);
    } else if (key == "file") {
      text = &(*part)["setup"]["files"][rest];
    } else if (key == "channel") {
      text = &(*part)["setup"]["channels"][rest]["program"];
    }
  }
  return cases;
}

void for_each_case(const std::function<void(const Json&, const std::string&)>& use) {
  namespace fs = std::filesystem;
  std::size_t golden = 0;
  std::size_t own = 0;
  for (const char* const folder : {"/tests/golden", "/tests/cases"})
    for (const auto& entry : fs::recursive_directory_iterator(KADR_ROOT + std::string(folder))) {
      std::ifstream stream(entry.path());
      if (entry.path().extension() == ".json" && entry.path().filename() != "schema.json") {
        use(Json::parse(stream), entry.path().filename());
        ++golden;
      } else if (entry.path().extension() == ".cases") {
        for (const Json& given : cases_of(lines_of(stream))) {
          use(given, entry.path().filename().string() + ": " + given["id"].get<std::string>());
          ++own;
        }
      }
    }
  EXPECT_GT(golden, 0U);
  EXPECT_GT(own, 0U);
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
