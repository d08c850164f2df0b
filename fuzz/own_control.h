#pragma once
// Generates random control files, and programs that use their codes: bytes → TOML text and blocks. A file is one of the five controls
// with a few changes, so that the loader accepts many of the files. An accepted control must run any program. Used by
// fuzz/own_control_fuzz.cpp and tests/control/own_control_test.cpp.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/control/control_def.h"
#include "run_program.h"

namespace kadr::fuzz {

inline constexpr std::string_view bases[] = {"gost", "s2c42", "mach3", "correctors", "nct"};

/// Makes random choices from the input bytes. When the bytes are used up, every further choice is the first option.
class Dice {
 public:
  Dice(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  std::size_t below(std::size_t count) {
    std::size_t number = 0;
    for (std::size_t reach = 1; reach < count; reach *= 256) number = number * 256 + (at_ < size_ ? data_[at_++] : 0u);
    return number % count;
  }
  bool one_in(std::size_t count) { return below(count) + 1 == count; }
  template <class T, std::size_t N>
  T of(const T (&all)[N]) {
    return all[below(N)];
  }
  bool empty() const { return at_ >= size_; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

inline std::string some_letters(Dice& dice, std::size_t most) {
  constexpr std::string_view letters = "XYZABCIJKRPQLFSTDHEUVWNGMO*";
  std::string text;
  for (std::size_t n = dice.below(most + 1); n > 0; --n) text += letters[dice.below(letters.size())];
  return text;
}

inline std::string phase_list() {
  std::string list;
  for (std::size_t p = 0; p < static_cast<std::size_t>(Phase::none); ++p)
    list += (p == 0 ? "\"" : ", \"") + std::string(name_of(static_cast<Phase>(p))) + "\"";
  return list;
}

inline std::string_view some_function(Dice& dice) {
  return traits_of(static_cast<Function>(dice.below(static_cast<std::size_t>(Function::count)))).name;
}

/// Returns a table row of [g] or [m] for a code with this function.
inline std::string code_row(Dice& dice, std::string_view function) {
  std::string row = "{ does = \"" + std::string(function) + "\"";
  if (!dice.one_in(3)) row += ", takes = \"" + some_letters(dice, 8) + "\"";
  if (dice.one_in(6)) row += ", needs = \"" + some_letters(dice, 2) + "\"";
  if (dice.one_in(3)) row += ", arg = " + std::to_string(dice.of({1, 2, 3, 0, 6, 17, 19, 437, 660, 717, 777, 730, 1000}));
  if (dice.one_in(2)) row += ", group = \"own" + std::to_string(dice.below(2)) + "\"";
  if (dice.one_in(5)) row += dice.one_in(2) ? ", modal = true" : ", modal = false";
  for (const char* const key : {"own_block", "needs_axis"})
    if (dice.one_in(8)) row += std::string(", ") + key + " = true";
  if (dice.one_in(8))
    row += ", phase = \"" + std::string(name_of(static_cast<Phase>(dice.below(static_cast<std::size_t>(Phase::none))))) + "\"";
  if (dice.one_in(10)) row += ", with = [\"G300\", \"M301\"]";
  if (dice.one_in(12)) row += ", works = false";
  return row + " }\n";
}

inline std::string address_row(Dice& dice) {
  std::string row(1, static_cast<char>('A' + dice.below(26)));
  row += " = { does = \"" + std::string(some_function(dice)) + "\"";
  if (dice.one_in(2)) row += std::string(", axis = \"") + dice.of({"X", "Y", "Z", "A"}) + "\"";
  if (dice.one_in(3)) row += std::string(", unit = \"") + dice.of({"length", "angle", "inch"}) + "\"";
  if (dice.one_in(3)) row += std::string(", scale = ") + dice.of({"0.1", "1e300", "-1", "0.0", "nan"});
  if (dice.one_in(3)) row += std::string(", format = \"") + dice.of({"+free", "free", "+043", "02", "9"}) + "\"";
  if (dice.one_in(5)) row += std::string(", ") + dice.of({"many = true", "second = true", "whole = true", "least = 0", "most = 5"});
  return row + " }\n";
}

inline std::string grammar_line(Dice& dice) {
  constexpr const char* flags[] = {"block_number_required",
                                   "program_start_required",
                                   "percent_number",
                                   "percent_ignored",
                                   "semicolon_comments",
                                   "slash_comments",
                                   "expressions",
                                   "lower_case",
                                   "main_blocks",
                                   "skip_levels",
                                   "mark_everywhere",
                                   "zero_between_slashes",
                                   "macro",
                                   "operator_i",
                                   "comments_span_lines",
                                   "comma_words",
                                   "file_names"};
  constexpr const char* others[] = {"variables = 0",
                                    "variables = 999",
                                    "variables = 151150",
                                    "label = \"O\"",
                                    "label = \"X\"",
                                    "section = \"L\"",
                                    "formal_parameter = \"R\"",
                                    "parameters_in = \"XYZF\"",
                                    "end_of_block = \"line\"",
                                    "end_of_block = \"line_only\"",
                                    "block_length = 20",
                                    "most_codes = { G = 2, M = 1 }",
                                    "percent_digits = 2",
                                    "comment_forbidden = \"%\""};
  if (dice.one_in(3)) return std::string(dice.of(others)) + "\n";
  return std::string(dice.of(flags)) + (dice.one_in(3) ? " = false\n" : " = true\n");
}

inline std::string behaviour_line(Dice& dice) {
  constexpr const char* flags[] = {"arc_radius_word", "feed_required", "speed_needs_direction", "tool_and_corrector", "rapids_apart",
                                   "end_required",    "ends_reading",  "delayed_assignment",    "feed_of_axis"};
  constexpr const char* others[] = {"compensation_entry = \"tangent\"",
                                    "compensation_entry = \"queued\"",
                                    "arc_radius_word = \"before_centre\"",
                                    "arc_radius_difference = [0.01, 0.05]",
                                    "arc_centers = \"by_code\"",
                                    "arc_centers = \"as_distance\"",
                                    "length_offset = \"at_once\"",
                                    "arc_radius_difference = 100",
                                    "feed_most = 10",
                                    "reference_feed = 0.001",
                                    "return_chip_break = 5",
                                    "return_near = 100",
                                    "probe_least_distance = 9",
                                    "call_depth = 1",
                                    "call_depth = 255",
                                    "offsets = 0",
                                    "offsets = 9999",
                                    "fixtures = 1",
                                    "fixtures = 1000",
                                    "arc_radius_difference = nan",
                                    "return_near = -5"};
  if (dice.one_in(3)) return std::string(dice.of(others)) + "\n";
  return std::string(dice.of(flags)) + (dice.one_in(3) ? " = false\n" : " = true\n");
}

inline std::string cycle_table(Dice& dice) {
  std::string text = std::string("[cycle.") + dice.of({"G300", "G301", "L81", "L90", "M300"}) + "]\n";
  if (dice.one_in(3)) {
    text += std::string("body = [\"G1 Z+R1 F+R0\", \"") + dice.of({"L90", "M17", "M2", "G0 Z1", "H2", "M20"}) + "\", \"M17\"]\n";
  } else {
    text += "steps = [";
    for (std::size_t n = dice.below(5) + 1; n > 0; --n)
      text += "\"" + std::string(name_of(static_cast<CycleStep>(dice.below(static_cast<std::size_t>(CycleStep::count))))) + "\", ";
    text += "]\n";
  }
  if (!dice.one_in(4)) text += std::string("needs = \"") + dice.of({"ZR", "ZRQ", "ZRQPIJK", "R", ""}) + "\"\n";
  return text;
}

inline std::string variable_table(Dice& dice) {
  std::string text =
      std::string("[[variables]]\nis = \"") +
      dice.of({"home", "home_second", "fixture", "fixture_number", "set_position", "probe_point", "free", "clock", "modal_group"}) + "\"\n";
  text += std::string("from = ") + dice.of({"1000", "5", "9990", "500000"}) + "\ncount = " + dice.of({"6", "1", "0", "100000"}) + "\n";
  if (dice.one_in(2))
    text += std::string("stride = ") + dice.of({"20", "6", "0", "1"}) + "\nrepeat = " + dice.of({"254", "6", "1", "100000"}) + "\n";
  return text;
}

/// Returns a complete control file. `function` is the function of the code G300; it may be none.
inline std::string control_file(Dice& dice, std::string_view base, std::string_view function) {
  std::string grammar, behaviour, address, codes, others, rest, parameters;
  const auto number = [&] { return "\"30" + std::to_string(dice.below(4) + 1) + "\" = "; };
  if (!function.empty()) codes = "\"300\" = " + code_row(dice, function);
  std::array<bool, 5> used{};  // for each key, whether it has been written: a key may occur only once
  for (std::size_t changes = dice.below(function.empty() ? 6 : 3); changes > 0; --changes) {
    const std::size_t kind = dice.below(9);
    if (kind < used.size() && std::exchange(used[kind], true)) continue;
    switch (kind) {
      case 0: grammar = grammar_line(dice); break;
      case 1: behaviour = behaviour_line(dice); break;
      case 2: address = address_row(dice); break;
      case 3: rest += cycle_table(dice); break;
      case 4: others += number() + code_row(dice, some_function(dice)); break;
      case 5: rest += variable_table(dice); break;
      case 6:
        if (rest.find("[defaults]") == std::string::npos)
          rest += std::string("[defaults]\nend = [\"") + dice.of({"G0", "G300", "M5", "M2", "M301", "G40"}) + "\"]\n";
        break;
      case 7:
        if (rest.find("[axes]") == std::string::npos)
          rest += std::string("[axes]\nnames = [") +
                  dice.of({"\"X\", \"Y\", \"Z\"", "\"X\"", "\"X\", \"Z\"", "\"X\", \"Y\", \"Z\", \"A\"", "\"X\", \"X\", \"Z\""}) + "]\n";
        break;
      default:
        codes += number() + code_row(dice, some_function(dice));
        changes = 1;
        break;
    }
  }
  std::string text =
      "id = \"mine\"\nextends = \"" + std::string(base) + "\"\n[groups]\nown0 = { modal = true }\nown1 = { modal = false }\n";
  text += "[order]\nphases = [" + phase_list() + "]\n";
  if (!grammar.empty()) text += "[grammar]\n" + grammar;
  if (!behaviour.empty()) text += "[behaviour]\n" + behaviour;
  if (!address.empty()) text += "[address]\n" + address;
  if (!codes.empty()) text += "[g]\n" + codes;
  if (!others.empty()) text += "[m]\n" + others;
  return text + rest;
}

inline std::string some_words(Dice& dice) {
  std::string text;
  for (std::size_t n = dice.below(5); n > 0; --n) {
    text += static_cast<char>('A' + dice.below(26));
    text += dice.of({"1", "2", "5", "10", "100", "-3", "0", "1.5", "0304", "300", "81", "#1", "[1+2]", "R1", ""});
    text += ' ';
  }
  return text;
}

/// Returns blocks that use the codes of the file. They are numbered from 1, since some controls require block numbers.
inline std::string program_of(Dice& dice, std::size_t blocks) {
  constexpr const char* lines[] = {"G300 X1 Y2 Z3",
                                   "G300",
                                   "G300 X5",
                                   "X7 Y1",
                                   "G1 X1 F100",
                                   "G2 X3 Y4 I1 J1",
                                   "G3 X1 R5",
                                   "G0 X0 Y0 Z5",
                                   "G41 D1",
                                   "G40",
                                   "G43 H1",
                                   "G18",
                                   "G91",
                                   "G90",
                                   "G301 Z-3 R2 Q1 F100 X1",
                                   "G302 P1 L2",
                                   "G303 R30",
                                   "M301",
                                   "M303 P1",
                                   "M98 P100",
                                   "M99",
                                   "M17",
                                   "M20",
                                   "H2",
                                   "L0102",
                                   "L81",
                                   "L90",
                                   "T0304",
                                   "T1 M6",
                                   "S500 M3",
                                   "G54",
                                   "G59",
                                   "G92 X1",
                                   "G10 L2 P3 X1",
                                   "G10 L1 P1 Z5",
                                   "G28 X0",
                                   "G51 X2",
                                   "G68 A0 B0 R30",
                                   "G16",
                                   "G76 X1 Y1 Z-2 R1 Q1",
                                   "G81 X1 Z-5 R1",
                                   "G81.1",
                                   "#1=5",
                                   "#500=#1+[2*3]",
                                   "R1=1000",
                                   "IF[#1EQ5]GOTO1",
                                   "GOTO 2",
                                   "WHILE[#1LT9]DO1",
                                   "END1",
                                   "G65 P9010 A1",
                                   "G66 P1",
                                   "M30",
                                   "M2",
                                   "O100",
                                   "L",
                                   "/G300 X1",
                                   "(MSG,HELLO)",
                                   "%",
                                   "X-3 (C)",
                                   "E5",
                                   "G4 P1",
                                   "G4 E5",
                                   "F0",
                                   "G95 F1",
                                   "G96 S100",
                                   "G53 X0",
                                   "G31 Z-3 F10",
                                   "G12 I2",
                                   "G87 X9 Y9 Z-3 R3 I30 J1 K1",
                                   "G79 Z1",
                                   "G25",
                                   "G26 X1",
                                   "DPRNT[X#1[53]]",
                                   "M98<a.nc>",
                                   "XI3",
                                   ",C1"};
  std::string text = dice.one_in(4) ? "" : "%\n";
  for (std::size_t n = 1; n <= blocks; ++n) {
    if (!dice.one_in(5)) text += "N" + std::to_string(n) + " ";
    text += dice.of(lines);
    text += ' ';
    if (dice.one_in(2)) text += some_words(dice);
    text += '\n';
  }
  return text;
}

/// The loader's result for a control file.
enum class Tried : std::uint8_t { refused, ran };

/// Loads the file; if it is accepted, runs the program on the control. `refusal` receives the loader's error sentence.
inline Tried try_own(const std::string& file, const std::string& program, unsigned switches, std::string* refusal = nullptr) {
  static Shop shop = Shop::open("gost");
  auto def = parse_control(file, "own.toml");
  if (!def) {
    require(!def.error().empty(), "a refusal says why");
    if (refusal != nullptr) *refusal = def.error();
    return Tried::refused;
  }
  shop.def = std::move(*def);
  shop.plain_frames = false;
  shop.file = "/nonexistent/own.nc";  // in a folder that does not exist, so that the program can call no file of this computer
  shop.limits = {300, 2};
  run_text(shop, program, switches);
  return Tried::ran;
}

}  // namespace kadr::fuzz
