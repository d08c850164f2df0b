#pragma once
// Programs for tests that execute whole runs: golden cases, our own cases, the examples, random programs.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "case_files.h"
#include "config/setup/setup_file.h"

namespace kadr::test {

namespace fs = std::filesystem;

/// A program in a folder of its own, laid out as the runner of the golden cases does it.
struct Work {
  std::string id, where, program, main_file;
  Setup setup;
};

/// Returns a description of the first line in which two texts differ, empty if they are equal.
inline std::string difference(const std::string& a, const std::string& b) {
  std::istringstream left(a), right(b);
  std::string one, other;
  while (true) {
    const bool more = static_cast<bool>(std::getline(left, one)), more_there = static_cast<bool>(std::getline(right, other));
    if (!more && !more_there) return "";
    if (!more) one = "(nothing)";
    if (!more_there) other = "(nothing)";
    if (one != other) return "never stopped: " + one.substr(0, 400) + "\n  restored:      " + other.substr(0, 400);
  }
}

/// A temporary working directory that holds the files of a case; the destructor removes it with its content.
class Folder {
 public:
  Folder() : before_(fs::current_path()) {
    std::string name = (fs::temp_directory_path() / "kadr_snapshot_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
    fs::current_path(path_);
  }
  ~Folder() {
    fs::current_path(before_);
    fs::remove_all(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  void put(const test::Json& files) {
    for (const auto& entry : fs::directory_iterator(path_)) fs::remove_all(entry);
    for (const auto& [name, text] : files.items()) {
      const fs::path file = path_ / name;
      fs::create_directories(file.parent_path());
      std::ofstream(file) << text.get<std::string>();
    }
  }

 private:
  fs::path before_, path_;
};

/// Calls `use` with each golden and own case, with the case's files in the
/// working directory. Cases that begin with a block search are left out.
inline void for_each_program(const std::function<void(const Work&)>& use) {
  Folder folder;
  for_each_case([&](const Json& given, const std::string& where) {
    const std::string id = given.value("control", "");
    const auto setups = setups_of(given);
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const auto setup = parse_setup(setups[i].dump());
      if (!setup || setups[i].contains("search")) continue;
      const Json variant = given.contains("variants") ? given["variants"][i] : Json::object();
      const std::string program = variant.contains("program") ? variant["program"].get<std::string>() : given["program"].get<std::string>();
      folder.put(setups[i].value("files", Json::object()));
      const std::string main = setups[i].value("main_file", id == "nct" ? "main.nct" : "main.nc");
      std::ofstream(main) << program;
      use({id, where, program, main, *setup});
    }
  });
}

/// Calls `use` with each example and the set-up in the .json file of the same name.
inline void for_each_example(const std::function<void(const Work&)>& use) {
  for (const std::string id : {"s2c42", "mach3", "nct", "correctors", "gost"})
    for (const auto& entry : fs::directory_iterator(KADR_ROOT "/examples/" + id)) {
      const std::string ending = entry.path().extension();
      if (ending == ".json" || ending == ".toml" || ending == ".md" || ending == ".svg") continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string program((std::istreambuf_iterator<char>(stream)), {});
      std::ifstream set_up(fs::path(entry.path()).replace_extension(".json"));
      const std::string json((std::istreambuf_iterator<char>(set_up)), {});
      use({id, entry.path(), program, entry.path(), json.empty() ? Setup() : parse_setup(json).value()});
    }
}

// ---- random programs

/// The forms of block from which random programs of each control are built. A letter alone gets a number; `@` becomes a line number.
inline const std::map<std::string, std::vector<std::string>> blocks_of = {
    {"nct",
     {"G0 X Y",
      "G1 X Y F",
      "G2 X Y R",
      "G3 X Y I J",
      "G90",
      "G91",
      "G17",
      "G18",
      "G41 D1 X Y",
      "G42 D1 X",
      "G40 X Y",
      "G43 H1 Z",
      "G49",
      "G54",
      "G55",
      "G94",
      "G95",
      "S M3",
      "M5",
      "T1 M6",
      "G81 X Y Z R F",
      "X Y",
      "G83 X Z R Q1 F",
      "G80",
      "G68 X Y R",
      "G69",
      "G51.1 X",
      "G50.1",
      "G16",
      "G15",
      "G10 L2 P1 X",
      "G10 L10 P1 R",
      "G52 X",
      "G92 X",
      "G20",
      "G21",
      "G4 P1",
      "G33 Z F1",
      "G28 X",
      "#1=#1+1",
      "#100=#100+X",
      "#500=#5001",
      "IF[#1LT5]GOTO@",
      "IF[#100LT30]THEN#100=#100+1",
      "WHILE[#2LT3]DO1",
      "#2=#2+1",
      "END1",
      "G65 P9100 A B",
      "M98 P9101 L2",
      "G66 P9100 A",
      "G67",
      "G1 X#1 Y#100",
      "G31 X F",
      "G96 S",
      "G97 S",
      "M99",
      "/G1 X Y F",
      "G10 L52",
      "N1339 R0.5",
      "G11",
      "X@",
      "#3000=1(A)",
      "G2 X",
      "DPRNT[X#1[31]]"}},
    {"mach3",
     {"G0 X Y",
      "G1 X Y F",
      "G2 X Y R",
      "G3 X Y I J",
      "G90",
      "G91",
      "G17",
      "G18",
      "G41 P2 X Y",
      "G42 P2 X",
      "G40 X Y",
      "G43 H1",
      "G49",
      "G54",
      "G59 P3",
      "G94",
      "G95",
      "S M3",
      "M5",
      "T1 M6",
      "G81 X Y Z R F",
      "X Y",
      "G83 X Z R Q1 F",
      "G80",
      "G68 A0 B0 R",
      "G69",
      "G51 X2",
      "G50",
      "G15",
      "G16",
      "G10 L2 P1 X",
      "G52 X",
      "G92 X",
      "G92.1",
      "G20",
      "G21",
      "G4 P1",
      "G28 X",
      "#1=[#1+1]",
      "G1 X#1 Y[#2*2]",
      "#2=[SIN[#1]] X#2",
      "M98 P100 L2",
      "M99",
      "/G1 X Y F",
      "G31 X F",
      "G93",
      "G98",
      "G99",
      "G82 X Z R P1 F",
      "X@"}},
    {"gost", {"G0 X Y", "G1 X Y F", "G2 X Y I J", "G90",   "G91", "G17",           "G18", "G40",     "G41 D1 X Y", "G43 H1 Z", "G54", "G94",
              "G95",    "S M3",     "M5",         "T1 M6", "X Y", "G81 X Y Z R F", "G80", "G92 X Y", "G4 X1",      "M8",       "M9",  "Z"}},
    {"correctors",
     {"G0 X Y", "G1 X Y F", "G2 X Y I J", "G90", "G91", "X Y", "L17 X", "G41 L17 X", "L2 15 X Y", "G40", "S M3", "T0101 M6", "F", "Z",
      "G4 F1", "M8", "G1 X L17"}},
    {"s2c42",
     {"N@ G0 X Y", "N@ G1 X Y F", "N@ G2 X Y I J", "N@ G90",      "N@ G91",   "N@ X Y", "N@ G17",   "N@ G54",  "N@ G92 X",
      "N@ S M3",   "N@ T1 M6",    "N@ Z",          "N@ G41 D1 X", "N@ G40 X", "N@ H3",  "N@ X M20", "N@ R1 5", "N@ L81 R2-5 R3-20 R10 R7 1",
      "N@ G43 D1", "N@ M5",       "N@ G4 F1"}}};

/// Blocks of chapter 25 of the NCT manual, for a machine with the axes A and C.
inline const std::vector<std::string> five_axis_blocks = {"G0 X Y Z",
                                                          "G1 X Y Z F",
                                                          "G1 X Y A C F",
                                                          "A C",
                                                          "G91 A5",
                                                          "G90",
                                                          "G0 A C",
                                                          "G2 X Y R",
                                                          "G3 X Y I J",
                                                          "G2 X1 Y2 R60 A C",
                                                          "G0 G43.1 H1",
                                                          "G0 G43.1 H1 Z A",
                                                          "G1 G43.4 H1 X F",
                                                          "G0 G43.4 H1 A C",
                                                          "G1 G43.4 P1 H1 F",
                                                          "G0 G43.5 H1 I J K",
                                                          "G1 G43.5 P1 H1 I J K50 F",
                                                          "G1 X Y I J K40",
                                                          "G1 X I0 J1 K2",
                                                          "G0 G43.8 H1 D1 ,L2 I J K",
                                                          "G0 G43.9 H1 D1 I0 J0 K1 ,L2 I0 J0 K1",
                                                          "G1 X Y F ,L2 I J K40",
                                                          "G49",
                                                          "G49 Z",
                                                          "G43 H1 Z",
                                                          "G68.2 X Y Z I J K",
                                                          "G68.2 P1 Q123 X I J K",
                                                          "G68.2 P2 Q1 X Y Z",
                                                          "G68.2 P2 Q2 X Y Z",
                                                          "G68.2 P2 Q3 X Y Z",
                                                          "G68.2 P2 Q0 R",
                                                          "G68.2 P3 Q1 X I J K",
                                                          "G68.2 P3 Q2 I J K",
                                                          "G68.2 P4 X I J K",
                                                          "G68.1 X I0 J1 K0 R",
                                                          "G69.1",
                                                          "G69.1",
                                                          "G53.1",
                                                          "G53.6 H1",
                                                          "G53.6 H1 R50",
                                                          "G53.6 H1 X Y",
                                                          "G54.2 P1",
                                                          "G54",
                                                          "G54",
                                                          "G55",
                                                          "G52 X",
                                                          "G92 Z",
                                                          "G68 X Y R",
                                                          "G69",
                                                          "G81 X Y Z R F",
                                                          "G80",
                                                          "G41 D1 X",
                                                          "G40 X Y",
                                                          "G18",
                                                          "G17",
                                                          "G28 Z",
                                                          "G53 Z",
                                                          "G20",
                                                          "G21",
                                                          "#100=#5041",
                                                          "G1 X#100 F100"};

inline std::string random_program(const std::string& id, std::mt19937& choose, const std::vector<std::string>& all) {
  const auto below = [&](std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(choose); };
  std::string text = id == "correctors" || id == "s2c42" || id == "gost" ? "%\n" : "";
  const std::size_t lines = 5 + below(60);
  for (std::size_t i = 1; i <= lines; ++i) {
    if (id == "nct") text += "N" + std::to_string(i) + " ";
    const std::string& form = all[below(all.size())];
    for (std::size_t c = 0; c < form.size(); ++c) {
      const bool alone = form[c] >= 'A' && form[c] <= 'Z' && (c + 1 == form.size() || form[c + 1] == ' ') && (c == 0 || form[c - 1] == ' ');
      if (form[c] == '@') text += std::to_string(id == "nct" ? 1 + below(lines) : i);
      else text += form[c];
      if (alone) text += std::to_string(static_cast<int>(below(90)) - 30);
    }
    text += "\n";
  }
  if (id == "mach3") text += "M30\nO100\nG91 G1 X1 F50\nG90\nM99\n";
  else if (below(2) == 0) text += id == "nct" ? "M30\n" : "M2\n";
  return text;
}

inline std::string random_program(const std::string& id, std::mt19937& choose) { return random_program(id, choose, blocks_of.at(id)); }

}  // namespace kadr::test
