// config/control/guess: guesses the control from the text of a program. Checked with the golden programs, the examples and small samples.

#include "config/control/guess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "config/control/control_file.h"
#include "config/control/guess_pattern.h"
#include "lang/text/encoding.h"

namespace kadr::guess_test {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Returns a program as UTF-8, whatever its encoding.
std::string program_of(const std::filesystem::path& path) {
  const std::string bytes = text_of(path);
  std::string text;
  EXPECT_TRUE(append_utf8(bytes, detect_encoding(bytes).value_or(Encoding::utf8), text)) << path;
  return text;
}

/// A few lines of an example from a manual are often not enough to name the control; but a decisive guess must be right.
TEST(guess, of_the_golden_programs) {
  std::map<std::string, int> decided;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(KADR_ROOT "/tests/golden")) {
    if (entry.path().extension() != ".json" || entry.path().filename() == "schema.json") continue;
    const auto golden = nlohmann::json::parse(text_of(entry.path()));
    if (!golden.contains("program")) continue;  // only its variants have programs
    const std::string control = golden.at("control");
    const Guess guess = guess_control(golden.at("program").get<std::string>());
    EXPECT_EQ(guess.dialect, "") << entry.path() << guess.reason_en;
    if (guess.control.empty() || !guess.decisive) continue;
    ++decided[control];
    // The G-code systems B and C of fanuc-t are controls too; a golden case selects them by a parameter
    const bool of_system = control == "fanuc-t" && (guess.control == "fanuc-t-b" || guess.control == "fanuc-t-c");
    EXPECT_EQ(of_system ? control : guess.control, control) << entry.path() << guess.reason_en;
  }
  for (const char* control : {"s2c42", "correctors", "linuxcnc", "nct", "fanuc", "fanuc-t", "haas", "grbl"})
    EXPECT_GT(decided[control], 0) << control;
}

TEST(guess, of_the_examples) {
  int programs = 0;
  for (const char* control : {"mach3", "s2c42", "gost", "correctors", "linuxcnc", "grbl", "haas", "fanuc", "nct"})
    for (const auto& entry : std::filesystem::directory_iterator(KADR_ROOT "/examples/" + std::string(control))) {
      const auto kind = entry.path().extension();
      if ((kind != ".nc" && kind != ".tap" && kind != ".ngc" && kind != ".nct") || entry.path().stem() == "factory_part")
        continue;  // this folder has a control of its own
      ++programs;
      const Guess guess = guess_control(program_of(entry.path()), "/" + std::string(control) + "/" + entry.path().filename().string());
      EXPECT_EQ(guess.control, control) << entry.path() << guess.reason_en;
    }
  EXPECT_GT(programs, 8);
}

// spec/gost 1: `%012`, or `%` and `O0001` as on Fanuc-like controls. spec/gost 2: every block is numbered. spec/gost 3: numbers have
// signs, and each code has two digits.
TEST(guess, program_number_behind_percent_tells_no_control) {
  const auto control = [](const char* text) { return guess_control(text).control; };
  EXPECT_EQ(control("%\nO0001\nN001 G90 G17\nN002 G01 X10. F100\nN003 M30\n"), "gost");
  EXPECT_EQ(control("%\nO0001\nN1 G00 X+10. Y-5.\nN2 M02\n"), "gost");
  EXPECT_EQ(control("%012\nN1 G90 G00 X10. Y5.\nN2 M02\n"), "gost");
  EXPECT_EQ(control("%\nO0001\nG90 G0 X10.\nG1 Z-1. F100\nM30\n%\n"), "fanuc");
  EXPECT_EQ(control("N1 G90 G0 X10.\nN2 M98 P5\nN3 M30\nO5\nN4 G1 X1. F100\nN5 M99\n"), "mach3");
  EXPECT_EQ(control("%\nO0001\nN10 G21 G90\nN20 G0 X10.5\nN30 #1=5\nN40 M30\n"), "fanuc");
}

TEST(guess, of_small_samples) {
  struct Case {
    const char* text;
    const char* control;
  };
  const Case cases[] = {
      {"G0 X1.5\nG1 Z-2\nM30\n", "mach3"},
      {"#100=5\nG1 X#100\n", "mach3"},
      {"O100\nG81 X1 Y1 Z-1 R2\n", "mach3"},
      {"% ПС\nN1 G0 X8000 ПС\nN2 M2 ПС\n", "s2c42"},
      {"%\nN1 G0 X8000\nN2 L81 R0+60 R1-5000 R2+2000\nN3 M2\n", "s2c42"},
      {"% LF\nN001 G91 Z-50. L4 04 LF\nN002 M02 LF\n", "correctors"},
      {"%012 LF\n:1 G90 G00 X10. LF\nN2 M02 LF\n", "gost"},
      {"", "mach3"},
      {"#1=5\nWHILE[#1GT0]DO1\nG1X#1\n#1=#1-1\nEND1\nM30\n", "fanuc"},
      {"N10 IF [#1 EQ 0] GOTO 100\nN20 G0 X1.5\nN100 M30\n", "fanuc"},
      {"G65 P9100 X10 Y20\nM30\n", "fanuc"},
      {"#1=5\nWHILE[#1GT0]DO1\nG1 X10\n#1=#1-1\nEND1\nM30\n", "nct"},
      {"#1=5\nWHILE[#1GT0]DO1\nG1 X10.\n#1=#1-1\nEND1\nM30\n", "fanuc"},
      {"#100=#_ABSIO[1]\nG0 X#100\n", "nct"},
      {"N1 G54.1 P3\nN2 G0 X0\nN3 G84.2 Z-10 R2 F1\nN4 M30\n", "nct"},
      {"G1 X50 F100 ,A30\nY20\n", "nct"},
      {"G90 G1 XI-40 F100\n", "nct"},
      {"FOPEN31\nDPRNT[X#1[53]]\nFCLOS31\n", "nct"},
      {"O100 WHILE [#1 LT 5]\nG1 X#1\nO100 ENDWHILE\n", "linuxcnc"},
      {"$H\nG21 G90\nG1 X10 F500\n", "grbl"},
      {"$J=G91 X10 F100\n", "grbl"},
      {"G90 G54 G0 X1.\nM97 P100\nM30\nN100 G1 X2. F10.\nM99\n", "haas"},
      {"G154 P3\nG0 X0. Y0.\nM30\n", "haas"},
      {"#1=5\nWH[#1GT0]DO1\nG1X#1F100\n#1=#1-1\nEND1\nM30\n", "fanuc"},
      {"G43 H1 Z10.\nM29 S500\nG84 X0 Y0 Z-8. R2. F500\nM30\n", "fanuc"},
      {"G0 X1.5 (GOTO, WHILE[ and G54.1 P1)\nG12 I5\nM30\n", "mach3"},
  };
  for (const Case& c : cases) EXPECT_EQ(guess_control(c.text).control, c.control) << c.text;
}

TEST(guess, tells_what_it_found_and_where) {
  const Guess guess = guess_control("%\nN1 G0 X8000\nN2 L81 R0+60 R1-5000\nN3 G1 X0 ПС\n");
  EXPECT_EQ(guess.reason_en,
            "line 3: R0+60, line 3: R1-5000, line 3: L81, line 4: ПС, numbers without points");  // in the order of the lines
  EXPECT_EQ(guess.reason_ru, "строка 3: R0+60, строка 3: R1-5000, строка 3: L81, строка 4: ПС, числа без точки");
  EXPECT_TRUE(guess.decisive);
  const Guess weak = guess_control("(a)\nG0 X1\n\nWHILE[#1 LT 2]DO1\nEND1\n");
  EXPECT_EQ(weak.reason_en, "line 4: WHILE[, line 4: #1, short lengths without points");
  EXPECT_FALSE(weak.decisive);
}

// The common guess for the programs of one folder.
TEST(guess, common_guess_of_a_folder) {
  const auto common = [](std::initializer_list<const char*> programs) {
    std::vector<Guess> guesses;
    for (const char* program : programs) guesses.push_back(guess_control(program));
    return common_guess(guesses).control;
  };
  EXPECT_EQ(common({"G154 P3\n", "G0 X1.5\nM30\n"}), "haas");
  EXPECT_EQ(common({"G154 P3\n", "$H\nG0 X1\n", "G0 X1.5\n"}), "");
  EXPECT_EQ(common({"#1=5\nWHILE[#1GT0]DO1\n#1=#1-1\nEND1\n", "G0 X1.5\n"}), "fanuc");
  EXPECT_EQ(common({}), "");
  EXPECT_EQ(common({"G154 P3\n", "G154 P4\n", "G187 P1\n", "$H\nG0 X1\n"}), "haas");  // three of four
}

// A dialect that Kadr does not read is also assumed for neighbouring programs if nothing in them contradicts it.
TEST(guess, neighbours_of_another_language) {
  const Guess fagor = guess_control("%00000\nN0 T1.1\nN10 M6\n"), edm = guess_control("(WEDM)\nM20\nG1 X5 Y5\n");
  const Guess weak = guess_control("N10 G0 X1 Y2\nN20 G1 Z-1\n");
  EXPECT_EQ(common_guess({fagor, weak}).dialect, "");  // one program alone is not enough evidence
  const CommonGuess two = common_guess({fagor, fagor, weak});
  EXPECT_EQ(two.dialect, "fagor");
  EXPECT_TRUE(may_be(weak, two, true));
  EXPECT_FALSE(may_be(weak, two, false));                                     // a .txt file among .nc files
  EXPECT_TRUE(may_be(guess_control("N0 T2.2\nN10 G0 X1 Y2\n"), two, false));  // T2.2
  EXPECT_FALSE(may_be(weak, common_guess({edm, edm, weak}), true));           // the program has Z
  const Guess lathe = guess_control("T0101\nG97 S100\nG71 U1.5 R0.5\nG71 P1 Q2 U0.4 W0.1 F0.2\nN1 G0 X5\nN2 G1 Z-5\nG50 S90\n");
  EXPECT_EQ(common_guess({lathe, lathe, weak}).control, "fanuc-t");
  EXPECT_FALSE(may_be(weak, common_guess({lathe, lathe, weak}), true));  // the program has Y
  EXPECT_TRUE(may_be(guess_control("G0 X1 Z2\nG99 G1 Z-1 F0.1\n"), common_guess({lathe, lathe, weak}), true));
}

TEST(guess, patterns) {
  const auto found = [](const char* line, const char* pattern) {
    const GuessLine forms = guess_line(line);
    return std::string(found_in(forms, pattern));
  };
  EXPECT_EQ(found("N10 M97 P10 ", "M97P"), "M97P");
  EXPECT_EQ(found("/2 N5 G05.1 Q1", "^G5.1Q\\d"), "G5.1Q1");
  EXPECT_EQ(found("G54.12", "G54.1"), "");
  EXPECT_EQ(found("G1547", "G154"), "");
  EXPECT_EQ(found("FIX[3]", "\\aI\\n"), "");
  EXPECT_EQ(found("G1 XI-4.5", "\\aI\\n"), "XI-4.5");
  EXPECT_EQ(found("(DEBUG, x)", "(DEBUG,"), "(DEBUG,");
  EXPECT_EQ(found("G1 X1 (G154 P1)", "G154P"), "");
  EXPECT_EQ(found("N1 Z-50. L4 04 LF", "L\\d \\d"), "L4 04");
  EXPECT_EQ(found("$X", "^$X$"), "$X");
  EXPECT_EQ(found("O00030", "^O0\\c\\c\\c\\c"), "O00030");
  EXPECT_EQ(found("O0001", "^O0\\c\\c\\c\\c"), "");
  EXPECT_EQ(found("G1 X1 Y2 E3", "G1\\*E\\n"), "G1X1Y2E3");
  EXPECT_EQ(found("G2 X1 E3", "G1\\*E\\n"), "");
  EXPECT_EQ(found("OPART", "^O\\l\\l"), "OPA");
  EXPECT_EQ(found("O<part>", "^O\\l"), "");
}

TEST(guess, comments_and_names) {
  const auto word = [](const char* line, const char* pattern) { return std::string(found_in_words(guess_line(line).comments, pattern)); };
  EXPECT_EQ(word("G0 X1 (for a Haas VF2)", "HAAS"), "HAAS");
  EXPECT_EQ(word("G0 X1 ; haas", "HAAS"), "HAAS");
  EXPECT_EQ(word("# Laser blue", "LASER"), "LASER");
  EXPECT_EQ(word("#1=5", "1=5"), "");
  EXPECT_EQ(word("(laserjet)", "LASER"), "");
  EXPECT_EQ(word("(ablaser)", "LASER"), "");
  EXPECT_EQ(word("HAAS (no)", "HAAS"), "");
  EXPECT_TRUE(is_named_like("/nc/Part.NGC", "*.ngc"));
  EXPECT_FALSE(is_named_like("/a.ngc/part.nc", "*.ngc"));
  EXPECT_TRUE(is_named_like("/My Haas/part.nc", "*/*haas*/*"));
  EXPECT_FALSE(is_named_like("/nc/haas.nc", "*/*haas*/*"));
}

/// Returns "fanuc?" for a weak guess, "grbl!" for a decisive one, "unknown:okuma" for a dialect that Kadr does not read.
std::string described(const Guess& guess) {
  if (guess.control.empty()) return guess.dialect.empty() ? "unknown" : "unknown:" + guess.dialect;
  return guess.control + (guess.decisive ? "!" : "?");
}

struct Head {
  std::string expected, path, text;
};

/// Reads the heads of programs, one per line: the expected guess, the file's name, and the program's lines with \n between them. Each
/// head tests a row of [guess] or a case where a row must not match.
std::vector<Head> heads() {
  std::vector<Head> all;
  std::ifstream file(KADR_ROOT "/tests/config/guess_heads.tsv");
  for (std::string line; std::getline(file, line);) {
    const std::size_t name = line.find('\t') + 1, text_at = line.find('\t', name) + 1;
    std::string text = line.substr(text_at) + "\n";
    for (std::size_t at = 0; (at = text.find("\\n", at)) != std::string::npos;) text.replace(at, 2, "\n");
    all.push_back({line.substr(0, name - 1), "/" + line.substr(name, text_at - 1 - name), text});
  }
  return all;
}

/// Returns the rows of the controls in controls/dialects.toml that are not built in, so that a head has the same guess with and without
/// them.
std::vector<GuessRows> readers_not_built_in() {
  const std::vector<std::string> built_in = built_in_controls();
  std::vector<GuessRows> all;
  for (const GuessRows& language : dialect_rows())
    for (const LanguageReader& reader : language.read_by) {
      if (std::find(built_in.begin(), built_in.end(), reader.id) != built_in.end()) continue;
      GuessRows& rows = all.emplace_back();
      rows.control = reader.id;
      add_rows_of_language(rows, reader.id);
    }
  return all;
}

TEST(guess, of_heads) {
  const std::vector<GuessRows> more = readers_not_built_in();
  for (const auto& [expected, path, text] : heads()) {
    const Guess guess = guess_control(text, path, more);
    EXPECT_EQ(described(guess), expected) << path << "\n" << text << guess.reason_en;
  }
  EXPECT_GT(heads().size(), 200U);
}

bool stands_in(const GuessMark& mark, const Head& head) {
  if (mark.place == MarkLocation::name) return is_named_like(head.path, mark.pattern);
  std::istringstream lines(head.text);
  for (std::string line; std::getline(lines, line);) {
    const GuessLine forms = guess_line(line);
    const bool in_comment = mark.place == MarkLocation::comment;
    const bool found = !(in_comment ? found_in_words(forms.comments, mark.pattern) : found_in(forms, mark.pattern)).empty();
    EXPECT_TRUE(!found || (signs_needed(mark.pattern) & ~signs_of(forms.raw)) == 0) << mark.pattern;  // must not be skipped
    if (found) return true;
  }
  return false;
}

// A row of [guess] without a matching head would not be tested.
TEST(guess, each_row_of_a_dialect_has_a_head) {
  const std::vector<Head> all = heads();
  const auto look = [&](const std::string& control, const GuessRows& rows) {
    for (const GuessMark& mark : rows.marks)
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Head& head) { return stands_in(mark, head); }))
          << control << ": " << mark.pattern;
  };
  for (const GuessRows& rows : dialect_rows()) {
    look(rows.control, rows);
    for (const LanguageReader& reader : rows.read_by) look(reader.id, reader.rows);
  }
}

// After a trial, a control that reads the program without a fault ranks before one that does not. If no control does, the trial changes
// nothing. A trial never adds a control for which there is no evidence.
TEST(guess, trial) {
  Guess guess = guess_control("G0 X10 Z5\nG1 X20 F100\nM30\n");
  ASSERT_EQ(guess.control, "grbl");
  const std::vector<std::string> candidates = candidates_of(guess);
  EXPECT_EQ(candidates, (std::vector<std::string>{"grbl", "mach3", "nct"}));
  take_trial(guess, {{"grbl", 1}, {"mach3", 2}, {"nct", 1}});
  EXPECT_EQ(guess.control, "grbl");
  take_trial(guess, {{"grbl", 1}, {"mach3", 2}, {"nct", 0}});
  EXPECT_EQ(guess.control, "nct");
  EXPECT_EQ(candidates_of(guess_control("G154 P3\nG0 X1.\n")), std::vector<std::string>());  // decisive: no candidates to try
}

// Two controls refuse a lathe's program if --control names them. The NCT reads it, because one parameter makes it a lathe (its 18.2).
TEST(guess, a_lathes_program_is_refused_by_mills) {
  const char* const program = "%\nO0001\nG21 G40 G99\nT0101\nG97 S1000 M03\nG00 X40. Z2.\nG01 Z-20. F0.2\nX44.\nG00 X100. Z50.\nM30\n%\n";
  const Guess guess = guess_control(program);
  EXPECT_EQ(guess.control, "fanuc-t");
  EXPECT_EQ(guess.refusal_en, "a lathe's program, line 3: G99, line 4: T0101, line 5: G97, no Y");
  EXPECT_EQ(guess.refused_by, (std::vector<std::string>{"fanuc", "haas"}));
  EXPECT_EQ(
      refused_by_control(program, "fanuc", Lang::en),
      "a lathe's program, line 3: G99, line 4: T0101, line 5: G97, no Y; of fanuc Kadr reads milling programs alone, turning is read by "
      "fanuc-t");
  for (const char* control : {"fanuc-t", "nct", "linuxcnc", "gost"})
    EXPECT_EQ(refused_by_control(program, control, Lang::en), "") << control;
  EXPECT_EQ(refused_by_control("%\nO0001\nG90 G54 G0 X1. Y2.\nG43 H1 Z5.\nG99 G81 Z-5. R2. F100.\n", "fanuc", Lang::en), "");
}

// A factory's own control that extends a lathe's control has the evidence of that control, and can be guessed by one mark more.
TEST(guess, own_control_for_a_lathe) {
  GuessRows own;
  own.control = "shop.toml";
  own.marks.push_back({"M51", 14, MarkLocation::statement, signs_needed("M51"), rarest_sign(signs_needed("M51"))});
  add_rows_of_language(own, "fanuc-t");
  const std::string program = "%\nO0001\nG99\nT0101\nG50 S2000\nG96 S180 M3\nG0 X40. Z2.\n";
  EXPECT_EQ(guess_control(program, {}, {own}).control, "fanuc-t");
  EXPECT_EQ(guess_control(program + "M51\nM30\n", {}, {own}).control, "shop.toml");
  EXPECT_TRUE(guess_control(program + "M51\nM30\n", {}, {own}).decisive);
  GuessRows mill;
  add_rows_of_language(mill, "fanuc");
  EXPECT_TRUE(mill.marks.empty());
}

TEST(guess, what_is_no_program_of_ours_is_unknown) {
  struct Case {
    const char* text;
    const char* reason;
  };
  const Case cases[] = {
      {"%P1 G71 *\nN10 G30 G17 X+0 Y+0 Z-20*\n", "Heidenhain DIN/ISO, line 1: %P1G71"},
      {"N1 G15 H1\nN2 CALL OO88\n", "Okuma, line 1: G15H1"},
      {"# Read me\n\nThis folder holds programs.\nSee there.\n", "few lines are blocks, the first that is none is line 1: # Read me"},
      {"Карта наладки\nдеталь 12\nФреза 8 мм\n", "few lines are blocks, the first that is none is line 1: Карта наладки"},
      {"int main() {\n  return 0;\n}\n", "few lines are blocks, the first that is none is line 1: int main() {"},
      {"\x7F"
       "ELF\x01\x02\x03\x04\x05",
       "it is no text"},
  };
  for (const Case& c : cases) {
    const Guess guess = guess_control(c.text);
    EXPECT_EQ(guess.control, "") << c.text;
    EXPECT_TRUE(guess.reason_en.starts_with(c.reason)) << c.text << guess.reason_en;
  }
}

TEST(guess, programs_are_not_taken_for_prose) {
  for (const char* text : {"o<probe> sub\n  #<x> = #1 (=1)\n  o10 if [#<x> GT 2]\n  o10 endif\no<probe> endsub\nM2\n",
                           "G0 X1 ; move to the first of all the holes\nM30 ; end of the whole program\n", "(только комментарий)\nG0 X1\n",
                           "M30\n", "%\n", "IF [#1 EQ 2] THEN #3=4\nGOTO 10\nN10 M99\n"})
    EXPECT_NE(guess_control(text).control, "") << text;
}

TEST(guess, does_not_read_comments) { EXPECT_EQ(guess_control("(L81 R1+5 ПС)\nG0 X1.5\n").control, "mach3"); }

}  // namespace
}  // namespace kadr::guess_test
