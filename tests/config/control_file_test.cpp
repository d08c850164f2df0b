// config/control/control_file: the built-in controls are consistent in themselves; a user's file extends one of them. Spec gost 3;
// docs/architecture.md.

#include "config/control/control_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "config/language.h"
#include "control/interpreter.h"
#include "own_place.h"

namespace kadr::control_file_test {
namespace {

class BuiltIn : public testing::TestWithParam<std::string> {
 protected:
  const ControlDef def = load_control(GetParam()).value();
};
/// Returns the name of a control as a name of a test, which has no hyphen.
std::string test_name(std::string id) {
  std::replace(id.begin(), id.end(), '-', '_');
  return id;
}
INSTANTIATE_TEST_SUITE_P(controls, BuiltIn, testing::ValuesIn(built_in_controls()), [](const auto& test) { return test_name(test.param); });

TEST(built_in_controls, are_the_files_of_the_folder_that_have_an_id) {
  const auto ids = built_in_controls();
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(KADR_ROOT "/controls")) {
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      if (line.starts_with("id = ")) files.insert(entry.path().stem().string());
  }
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()), files);
  EXPECT_GE(files.size(), 9U);
}

TEST_P(BuiltIn, is_named_by_its_id_in_both_languages) {
  EXPECT_EQ(def.id, GetParam());
  EXPECT_NE(def.name.en, "");
  EXPECT_NE(def.name.ru, "");
}

TEST_P(BuiltIn, every_code_calls_a_function_in_a_phase_of_the_order) {
  ASSERT_FALSE(def.codes.empty());
  for (const CodeRow& row : def.codes) {
    ASSERT_LT(row.function, Function::count) << row.code;
    EXPECT_NE(handler_of(row.function), nullptr) << row.code;
    if (row.phase != Phase::none) {
      EXPECT_NE(def.order[static_cast<std::size_t>(row.phase)], 0) << row.code;
    }
  }
  for (const AddressRow& row : def.addresses) {
    if (row.function == Function::count) continue;
    EXPECT_NE(handler_of(row.function), nullptr) << row.letter;
    EXPECT_TRUE(def.grammar.word(row.letter).known) << row.letter;
    if (row.phase != Phase::none) {
      EXPECT_NE(def.order[static_cast<std::size_t>(row.phase)], 0) << row.letter;
    }
  }
}

TEST_P(BuiltIn, phases_rank_as_the_file_lists_them) {
  std::uint8_t rank = 0;
  for (const Phase phase : def.order_list) EXPECT_EQ(def.order[static_cast<std::size_t>(phase)], ++rank) << name_of(phase);
}

TEST_P(BuiltIn, every_code_is_found_by_its_number) {
  for (std::size_t i = 0; i < def.codes.size(); ++i) {
    if (def.codes[i].tenth < 0) continue;  // M…, the row of all other M functions, has no number
    EXPECT_EQ(def.row_of(def.codes[i].letter, def.codes[i].tenth), static_cast<std::int32_t>(i)) << def.codes[i].code;
  }
  EXPECT_EQ(def.row_of('G', 9999), -1);
  EXPECT_EQ(def.row_of('G', -1), -1);
}

TEST_P(BuiltIn, rows_refer_to_groups_cycles_and_words_that_exist) {
  for (const CodeRow& row : def.codes) {
    EXPECT_LT(row.group, def.groups.size()) << row.code;
    EXPECT_EQ(row.cycle != 0, row.function == Function::cycle) << row.code;
    EXPECT_LE(row.cycle, def.cycles.size()) << row.code;
    EXPECT_EQ(row.needs & ~row.takes, 0u) << row.code << " needs what it does not take";
  }
  for (std::size_t g = 1; g < def.groups.size(); ++g)
    if (const std::int32_t row = def.groups[g].power_on; row >= 0) {
      EXPECT_EQ(def.codes[static_cast<std::size_t>(row)].group, g);
    }
}

TEST_P(BuiltIn, rows_say_what_they_are_in_both_languages_and_where_it_stands) {
  const bool extends_another = !def.lineage.empty();  // the sections of the manual of the NCT do not apply to extending controls
  for (const CodeRow& row : def.codes) {
    EXPECT_NE(row.text.en, "") << row.code;
    EXPECT_NE(row.text.ru, "") << row.code;
    EXPECT_TRUE(extends_another || !row.manual.empty()) << row.code;
  }
}

// ---- nct: what only this control's file contains

const ControlDef& nct() {
  static const ControlDef def = load_control("nct").value();
  return def;
}

const CodeRow& nct_code(char letter, int tenth) { return nct().codes.at(static_cast<std::size_t>(nct().row_of(letter, tenth))); }

const VariableRow& nct_variable(const std::string& symbol) {
  for (const VariableRow& row : nct().variables)
    if (row.symbol == symbol) return row;
  ADD_FAILURE() << symbol;
  return nct().variables.front();
}

TEST(nct, writes_macros) {
  const Grammar& g = nct().grammar;
  EXPECT_TRUE(g.custom_macros && g.operator_i && g.comments_span_lines && g.comma_words && g.file_names);
  EXPECT_FALSE(load_control("mach3").value().grammar.custom_macros);
  EXPECT_TRUE(nct().machine_axes());
}

TEST(nct, codes_take_every_axis_of_the_channel) {
  EXPECT_TRUE(nct_code('G', 0).takes_all_axes);
  // The code takes ,C ,R and ,A; these are not the letters C, R and A.
  EXPECT_EQ(nct_code('G', 0).takes, letter_bit(comma_chamfer) | letter_bit(comma_rounding) | letter_bit(comma_angle));
  EXPECT_EQ(nct().address(comma_chamfer).unit, WordUnit::length);
  EXPECT_FALSE(nct_code('G', 220).takes_all_axes);
}

TEST(nct, says_what_does_not_work) {
  EXPECT_FALSE(nct_code('G', 512).works);
  EXPECT_TRUE(nct_code('G', 430).works);
  EXPECT_TRUE(nct_variable("FOFS").works);
}

TEST(nct, m_codes_have_eight_digits) {
  EXPECT_EQ(nct_code('M', 999'999'990).function, Function::machine_function);
  EXPECT_EQ(nct().row_of('M', 1'000'000'000), -1);
  EXPECT_EQ(nct_code('M', 30).function, Function::spindle_code);
  EXPECT_EQ(nct_code('M', 30).arg, 3);
}

TEST(nct, variables_have_numbers_and_symbols) {
  const VariableRow& position = nct_variable("ABSMT");
  ASSERT_EQ(position.ranges.size(), 2u);
  EXPECT_EQ(position.ranges[0].from, 5021u);
  EXPECT_EQ(position.ranges[1].from, 100'051u);
  EXPECT_EQ(position.ranges[1].count, 50u);
  EXPECT_TRUE(position.read);
  EXPECT_FALSE(position.write);
  const VariableRow& family = nct_variable("WZP");
  EXPECT_EQ(family.ranges[1].stride, 50u);
  EXPECT_EQ(family.ranges[1].repeat, 99u);
  EXPECT_EQ(nct_variable("UI").first_index, 0u);
  EXPECT_EQ(nct_variable("INTF").arg, 2000 + 'F');
  EXPECT_EQ(nct_variable("WZG59").arg, 6);
  EXPECT_FALSE(nct_variable("ALM").read);
  const VariableRow& bit = nct_variable("M_EST");
  EXPECT_EQ(bit.bit, 2);
  EXPECT_EQ(bit.of, 3004u);
  EXPECT_GT(bit.ranges[0].from, first_unwritten_variable);
  EXPECT_EQ(nct_variable("TEST").of, nct_variable("CNTBS").ranges[0].from);
}

TEST(nct, alarms_have_the_controls_numbers_and_words) {
  EXPECT_EQ(nct().alarms.at(AlarmId::radius_mismatch).number, "2012");
  EXPECT_EQ(nct().alarms.at(AlarmId::bracket_not_closed).text.ru, "Правой скобки не найти");
  EXPECT_EQ(nct().alarms.at(AlarmId::m_codes_contradict).number, "");
}

// ---- a user's file

ControlDef extended(const std::string& toml) {
  auto def = parse_control(toml, "own.toml");
  if (!def) ADD_FAILURE() << def.error();
  return def.value();
}

std::string refusal(const std::string& toml) {
  const auto def = parse_control(toml, "own.toml");
  EXPECT_FALSE(def) << toml;
  return def ? "" : def.error();
}

const CodeRow* code_of(const ControlDef& def, char letter, int tenth) {
  const std::int32_t row = def.row_of(letter, tenth);
  return row < 0 ? nullptr : &def.codes[static_cast<std::size_t>(row)];
}

const std::string head = "id = \"own\"\nextends = \"gost\"\n";  // two lines

TEST(extends, alone_is_the_control_below) {
  const ControlDef own = extended(head);
  const ControlDef below = load_control("gost").value();
  EXPECT_EQ(own.id, "own");
  EXPECT_EQ(own.lineage, std::vector<std::string>{"gost"});
  EXPECT_EQ(own.codes.size(), below.codes.size());
  EXPECT_EQ(own.order_list, below.order_list);
  EXPECT_EQ(own.axes, below.axes);
}

TEST(extends, overrides_one_code_and_adds_one) {
  const ControlDef own = extended(head +
                                  "[g]\n\"94\" = { does = \"feed_per_revolution\" }\n\"770\" = { does = \"dwell\", phase = "
                                  "\"dwell_after\", takes = \"P\", en = \"a\", ru = \"b\" }\n");
  ASSERT_NE(code_of(own, 'G', 940), nullptr);
  EXPECT_EQ(code_of(own, 'G', 940)->function, Function::feed_per_revolution);
  ASSERT_NE(code_of(own, 'G', 7700), nullptr);
  EXPECT_EQ(code_of(own, 'G', 7700)->function, Function::dwell);
  EXPECT_EQ(own.codes.size(), load_control("gost").value().codes.size() + 1);
  EXPECT_EQ(code_of(own, 'G', 950)->function, Function::feed_per_revolution);  // not TOML
}

TEST(extends, keeps_what_the_changed_row_does_not_name) {
  const ControlDef own = extended(head + "[g]\n\"00\" = { en = \"fast\" }\n");
  EXPECT_EQ(code_of(own, 'G', 0)->function, Function::rapid);
  EXPECT_EQ(code_of(own, 'G', 0)->text.en, "fast");
}

TEST(extends, two_lays_the_rows_of_the_second_over_the_first) {
  const ControlDef own = extended(
      "id = \"own\"\nextends = [\"haas\", \"fanuc-t\"]\n[groups]\n\"22\" = { initial = \"G100\", en = \"a\", ru = \"b\" }\n"
      "[m]\n\"29\" = false\n");
  EXPECT_EQ(own.lineage, (std::vector<std::string>{"fanuc-t", "haas", "fanuc", "nct"}));
  EXPECT_NE(code_of(own, 'M', 970), nullptr) << "M97 of haas";
  EXPECT_EQ(code_of(own, 'M', 970)->function, Function::call_local);
  EXPECT_EQ(code_of(own, 'G', 710)->function, Function::turning_cycle) << "G71 of fanuc-t, not the holes of haas";
  EXPECT_EQ(own.behaviour.lathe, Lathe::fanuc);
  EXPECT_EQ(own.alarms.at(AlarmId::code_unknown).number, load_control("haas").value().alarms.at(AlarmId::code_unknown).number);
  EXPECT_FALSE(own.alarms.contains(AlarmId::figure_words)) << "fanuc-t gives its alarm numbers to no other control";
}

TEST(errors, of_an_unreadable_base) {
  for (const char* base : {"[\"haas\"]", "5", "[\"haas\", 5]", "[\"haas\", \"fanuc-t\", \"nct\"]"})
    EXPECT_NE(refusal("id = \"own\"\nextends = " + std::string(base) + "\n").find("own.toml:2"), std::string::npos) << base;
  EXPECT_NE(refusal("id = \"own\"\nextends = [\"nap\", \"fanuc-t\"]\n").find("nap"), std::string::npos);
}

TEST(errors, name_file_line_and_thing) {
  struct Case {
    const char* toml;
    const char* place;
    const char* thing;
  };
  const Case cases[] = {
      {"[g]\n\"04\" = { does = \"dwell\", takse = \"P\" }\n", "own.toml:4: ", "takse"},
      {"[g]\n\"4\" = { does = \"sleep\" }\n", "own.toml:4: ", "sleep"},
      {"[g]\n\n\"4\" = { does = \"linear\", group = \"nap\" }\n", "own.toml:5: ", "nap"},
      {"[g]\n\"4\" = { does = \"dwell\", phase = \"later\" }\n", "own.toml:4: ", "phase"},
      {"[g]\n\"4x\" = { does = \"dwell\" }\n", "own.toml:4: ", "4x"},
      {"[g]\n\"4\" = 5\n", "own.toml:4: ", "table"},
      {"[order]\nphases = [\"motion\", \"nap\"]\n", "own.toml:4: ", "nap"},
      {"[behaviour]\nsleepy = true\n", "own.toml:4: ", "sleepy"},
      {"[grammar]\nsleepy = true\n", "own.toml:4: ", "sleepy"},
      {"[alarms]\nsleepy = { en = \"x\" }\n", "own.toml:4: ", "sleepy"},
      {"[cycle.G81]\nsteps = [\"nap\"]\n", "own.toml:4: ", "step"},
      {"[nap]\n", "own.toml:3: ", "nap"},
      {"[[variables]]\nis = \"nap\"\n", "own.toml:4: ", "nap"},
      {"[[variables]]\nis = \"home\"\nranges = [[1, 2, 3]]\n", "own.toml:5: ", "[from, count]"},
      {"[[variables]]\nis = \"home\"\nranges = []\n", "own.toml:5: ", "ranges"},
      {"[[variables]]\nis = \"home\"\nranges = [[1, 2]]\nfrom = 1\n", "own.toml:6: ", "from"},
      {"[[variables]]\nis = \"home\"\nsymbol = \"a b\"\n", "own.toml:5: ", "symbol"},
      {"[[variables]]\nis = \"home\"\naccess = \"X\"\n", "own.toml:5: ", "access"},
      {"[[variables]]\nis = \"home\"\nnap = 1\n", "own.toml:5: ", "nap"},
      {"[alarms]\nno_axis_word = { nap = 1 }\n", "own.toml:4: ", "nap"},
      {"[g]\n\"4\" = { does = \"dwell\"\n", "own.toml:", ""},  // no TOML
  };
  for (const Case& c : cases) {
    const std::string sentence = refusal(head + c.toml);
    EXPECT_EQ(sentence.find(c.place), 0u) << c.toml << sentence;
    EXPECT_NE(sentence.find(c.thing), std::string::npos) << c.toml << sentence;
  }
}

// Machine files and set-ups use the same check: config/range.h.
TEST(errors, of_numbers_beyond_their_range) {
  const auto refused = [](const std::string& toml) { return refusal(head + toml); };
  for (const char* scale : {"0", "-1", "nan", "inf", "1e-300", "'1'", "true"})
    EXPECT_EQ(refused(std::string("[address]\nF = { scale = ") + scale + " }\n"),
              "own.toml:4: scale must be a number, 1e-09 to 1000000000");
  for (const char* feed : {"-5", "nan", "inf", "1e10"})
    EXPECT_EQ(refused(std::string("[behaviour]\nreference_feed = ") + feed + "\n"),
              "own.toml:4: reference_feed must be a number, 0 to 1000000000 mm/min");
  EXPECT_EQ(refused("[behaviour]\narc_radius_difference = -0.1\n"), "own.toml:4: arc_radius_difference must be a number, 0 to 10000000 mm");
  EXPECT_EQ(refused("[address]\nF = { least = nan }\n"), "own.toml:4: least must be a number");
  EXPECT_EQ(refused("[address]\nF = { least = 2, most = 1 }\n"), "own.toml:4: least is above most");
  EXPECT_EQ(refused("[feed_codes]\n01 = -1\n"), "own.toml:4: 01 must be a number, 0 to 1000000000 mm/min");
  EXPECT_EQ(refused("[speed_codes]\nfast = 1\n"), "own.toml:4: speed_codes: 'fast' is no code number");
  EXPECT_EQ(refused("a" +
                    []() {
                      std::string parts;
                      for (int i = 0; i < 50'000; ++i) parts += ".a";
                      return parts;
                    }() +
                    " = 1\n"),
            "own.toml:3:32: a key of more than 16 parts");
}

TEST(errors, in_a_row_laid_over_another_name_the_line_of_ones_own_file) {
  EXPECT_EQ(refusal(head + "[address]\nX = { axis = \"Nap\" }\n").find("own.toml:4: "), 0u);
  EXPECT_EQ(refusal(head + "[g]\n\"04\" = { does = \"sleep\" }\n").find("own.toml:4: "), 0u);
}

TEST(errors, of_a_code_twice) {
  // gost writes "04"; the same code with other digits would be a second row, so it is refused.
  const std::string sentence = refusal(head + "[g]\n\"4\" = { does = \"dwell\", phase = \"dwell_after\", takes = \"P\" }\n");
  EXPECT_EQ(sentence.find("own.toml:4: "), 0u) << sentence;
}

TEST(errors, of_what_is_missing) {
  EXPECT_NE(refusal("extends = \"nap\"\nid = \"own\"\n").find("nap"), std::string::npos);
  EXPECT_NE(refusal(head + "[groups]\nmotion = { initial = \"G4\" }\n").find("G4"), std::string::npos);
  EXPECT_FALSE(parse_control("", "own.toml"));
  const auto none = load_control("nap");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().find("mach3"), std::string::npos);  // the message lists the available ones
  EXPECT_FALSE(load_control("alarms"));
  EXPECT_FALSE(load_control("/no/such/file.toml"));
}

/// lang/block/format gives its reasons in English. Each of them must be a text of texts/en.toml, else it would stay English.
TEST(errors, of_a_format_are_translated) {
  set_thread_language(Lang::ru);
  for (const std::string format : {"X+053 LF Y+053", "0G2", "3", "X+053 X+053", "N043", "X-053", "X+0", "X+0537", "X+00"}) {
    const std::string refused = refusal(head + "format = \"" + format + "\"\n");
    const std::size_t at = refused.find("непонятен: ");
    ASSERT_NE(at, std::string::npos) << refused;
    EXPECT_NE(refused.find_first_of("\xD0\xD1", at + std::string("непонятен: ").size()), std::string::npos) << refused;
  }
  set_thread_language(Lang::en);
}

/// A file must not extend itself; a chain that is too long is refused with a message that says so.
TEST(errors, of_a_long_chain) {
  const std::filesystem::path folder = own_place("control_file");
  std::filesystem::create_directories(folder);
  for (int i = 0; i < 30; ++i)
    std::ofstream(folder / (std::to_string(i) + ".toml"))
        << "id = \"own" << i << "\"\nextends = \"" << (i == 0 ? "mach3" : std::to_string(i - 1) + ".toml") << "\"\n";
  for (const int i : {0, 8, 9, 14}) {
    const auto def = load_control((folder / (std::to_string(i) + ".toml")).string());
    EXPECT_TRUE(def) << i << ": " << (def ? "" : def.error());
  }
  const auto def = load_control((folder / "29.toml").string());
  ASSERT_FALSE(def);
  EXPECT_EQ(def.error().find("itself"), std::string::npos) << def.error();
  EXPECT_NE(def.error().find("16"), std::string::npos) << def.error();
  std::filesystem::remove_all(folder);
}

TEST(errors, of_a_file_that_extends_itself) {
  const std::filesystem::path folder = own_place("control_file");
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const char* base) {
    std::ofstream(folder / name) << "id = \"a\"\nextends = \"" << base << "\"\n";
  };
  write("itself.toml", "itself.toml");
  write("one.toml", "two.toml");
  write("two.toml", "one.toml");
  for (const char* name : {"itself.toml", "one.toml"}) {
    const auto def = load_control((folder / name).string());
    ASSERT_FALSE(def);
    EXPECT_NE(def.error().find("extends itself"), std::string::npos) << def.error();
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace kadr::control_file_test
