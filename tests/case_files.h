#pragma once
// Reads the golden cases (JSON) and our own cases (in the text form of
// tests/cases/reader.py) for C++ tests that need their set-ups and programs.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace kadr::test {

using Json = nlohmann::json;

/// Returns the lines of a file of cases; a line that begins with `| ` continues the line before it.
inline std::vector<std::string> lines_of(std::istream& stream) {
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("| ") && !lines.empty()) lines.back() += line.substr(1);
    else lines.push_back(line);
  }
  return lines;
}

/// Converts an indented line of a case into a line of the program: a JSON string becomes its text; in other lines the expected actions,
/// which ` -> ` begins, are cut off.
inline std::string program_line(const std::string& line) {
  std::string body = line.substr(4);
  if (body.starts_with('"')) {
    std::size_t end = 1;
    while (end < body.size() && body[end] != '"') end += body[end] == '\\' ? 2 : 1;
    return Json::parse(body.substr(0, end + 1)).get<std::string>();
  }
  body.erase(std::min(body.size(), body.find(" -> ")));
  body.erase(body.find_last_not_of(' ') + 1);
  return body;
}

/// Returns the cases of a text in the form of the golden cases. Of each case's expectations only `state` and `steps` are read.
inline std::vector<Json> cases_of(const std::string& control, const std::vector<std::string>& lines) {
  const Json empty = {{"setup", Json::object()}, {"expect", Json::object()}};
  std::vector<Json> cases;
  Json* part = nullptr;  // the case or the variant being read
  Json* text = nullptr;  // the program or the file being read
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string& line = lines[i];
    if (line.starts_with("    ")) {
      if (line.find_first_not_of(' ') == line.find("-> ")) continue;  // more actions expected of the line above
      if (text) *text = text->is_null() ? program_line(line) : text->get<std::string>() + "\n" + program_line(line);
      continue;
    }
    const std::string key = line.substr(0, line.find(' '));
    const std::string rest = line.substr(std::min(line.size(), key.size() + 1));
    if (key == "==") {
      part = &cases.emplace_back(empty);
      (*part)["id"] = rest.substr(0, rest.find(" |"));
      (*part)["control"] = control;
      text = &(*part)["program"];
      ++i;  // skips the title
    } else if (key == "--") {
      part = &cases.back()["variants"].emplace_back(empty);
      text = &(*part)["program"];
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
  const auto without_null = [](Json& part_read) {
    if (part_read["program"].is_null()) part_read.erase("program");
  };
  for (Json& one : cases) {
    without_null(one);
    if (one.contains("variants"))
      for (Json& variant : one["variants"]) without_null(variant);
  }
  return cases;
}

/// Calls `use` with each golden case, then with each of our own. `where` names the file and the case for failure messages.
inline void for_each_case(const std::function<void(const Json&, const std::string& where)>& use) {
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
        for (const Json& given : cases_of(entry.path().parent_path().filename(), lines_of(stream))) {
          use(given, entry.path().filename().string() + ": " + given["id"].get<std::string>());
          ++own;
        }
      }
    }
  EXPECT_GT(golden, 0U);
  EXPECT_GT(own, 0U);
}

/// Returns the set-ups of a case: its own one, or one per variant. A variant's
/// keys replace the case's keys; under `parameters` each parameter replaces one.
inline std::vector<Json> setups_of(const Json& given) {
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

}  // namespace kadr::test
