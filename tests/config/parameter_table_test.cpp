// config/setup/parameter_table: tables of parameters (nct 24), built in and damaged.

#include "config/setup/parameter_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "config/control/control_file.h"

namespace kadr::parameter_table_test {
namespace {

const std::vector<ParameterRow>& nct() {
  static const std::vector<ParameterRow> rows = load_parameters("nct-parameters").value();
  return rows;
}

const ParameterRow& named(std::string_view name) {
  const auto found = std::find_if(nct().begin(), nct().end(), [&](const ParameterRow& row) { return row.name == name; });
  return found == nct().end() ? throw std::out_of_range(std::string(name)) : *found;
}

TEST(parameter_table, is_sorted_by_number_and_those_without_one_stand_last) {
  ASSERT_GT(nct().size(), 200u);
  EXPECT_EQ(nct().back().name, "CLRG");
  for (std::size_t i = 1; i < nct().size(); ++i) EXPECT_TRUE(nct()[i].number > nct()[i - 1].number || nct()[i].number < 0) << nct()[i].name;
}

TEST(parameter_table, each_row_has_its_texts_and_a_range_that_holds_together) {
  for (const ParameterRow& row : nct()) {
    EXPECT_FALSE(row.text.en.empty() || row.text.ru.empty() || row.manual.empty()) << row.name;
    EXPECT_LE(row.least, row.most) << row.name;
    EXPECT_TRUE(row.bits.empty() || row.type == ParameterType::bits) << row.name;
    EXPECT_EQ(row.number, row.name == "CLRG" ? -1 : std::stoi(row.name));
  }
}

TEST(parameter_table, scopes_of_the_manuals_table) {  // 24.0
  EXPECT_EQ(named("2201").scope, ParameterScope::global);
  EXPECT_EQ(named("1500").scope, ParameterScope::channel);
  EXPECT_EQ(named("0106").scope, ParameterScope::axis);
  EXPECT_EQ(named("0608").scope, ParameterScope::spindle);
}

TEST(parameter_table, classes_of_the_manuals_example) {  // 24.1: these three are written by G10 L52
  for (const char* name : {"0107", "1339", "1746"}) EXPECT_EQ(named(name).when, ParameterClass::run_time) << name;
  for (const char* name : {"0100", "0106", "0604", "0819"}) EXPECT_EQ(named(name).when, ParameterClass::restart) << name;
}

TEST(parameter_table, bits_stand_at_their_numbers_and_the_others_behind_the_eighth) {
  EXPECT_EQ(named("0106").bits, (std::vector<std::string>{"DIA", "ROT", "", "", "", "MGD"}));
  EXPECT_EQ(named("0421").bits, (std::vector<std::string>{"", "JRK", "", "", "", "", "", "", "ROL"}));
  EXPECT_EQ(named("0104").bits.at(8), "IND");
  EXPECT_EQ(named("CLRG").bits.at(39), "C39");
  EXPECT_TRUE(named("1414").bits.empty());  // the names of its bits are not known
}

TEST(parameter_table, ranges_and_initial_values) {
  EXPECT_EQ(named("1404").most, 8);  // 15.5.7
  EXPECT_EQ(named("1409").least, 1);
  EXPECT_EQ(named("1714").most, 4294967295.);
  EXPECT_EQ(named("1339").initial, 0.01);
  EXPECT_EQ(named("0108").initial, 360);
  EXPECT_EQ(named("1400").initial, 999);
  EXPECT_EQ(named("1500").initial, 0);
}

const std::string head = "id = \"own\"\nextends = \"gost\"\n";

TEST(parameter_table, belongs_to_the_control_that_names_it) {
  const auto def = parse_control(head + "parameters = \"nct-parameters\"\n", "own.toml");
  ASSERT_TRUE(def) << def.error();
  EXPECT_EQ(def->parameters.size(), nct().size());
  EXPECT_TRUE(load_control("gost").value().parameters.empty());
  for (const char* none : {"\"gost\"", "\"nap-parameters\"", "7"}) {
    const auto refused = parse_control(head + "parameters = " + none + "\n", "own.toml");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().find("own.toml:3: no table of parameters"), 0u) << refused.error();
  }
}

TEST(parameter_table, is_no_control) {
  EXPECT_FALSE(load_control("nct-parameters"));
  const auto ids = built_in_controls();
  EXPECT_EQ(std::find(ids.begin(), ids.end(), "nct-parameters"), ids.end());
}

TEST(parameter_table, faults_are_told_with_file_and_line) {
  const struct {
    const char* toml;
    const char* sentence;
  } cases[] = {
      {R"("0100" = { scope = "axes", type = "real", en = "x" })", "scope must be one of global, channel, axis, spindle"},
      {R"("0100" = { type = "real", en = "x" })", "scope must be one of"},
      {R"("0100" = { scope = "axis", type = "bit", en = "x" })", "type must be one of"},
      {R"("0100" = { scope = "axis", type = "real", when = "never", en = "x" })", "when must be one of run_time, restart, emergency"},
      {R"("0100" = { scope = "axis", type = "real", en = "x", nap = 1 })", "unknown key 'nap'"},
      {R"("0100" = { scope = "axis", type = "real" })", "en is missing"},
      {R"("0100" = { scope = "axis", type = "real", en = "x", least = "1" })", "least must be a number"},
      {R"("0100" = { scope = "axis", type = "real", en = "x", most = nan })", "most must be a number"},
      {R"("0100" = { scope = "axis", type = "real", en = "x", least = 2, most = 1 })", "least is above most"},
      {R"("0100" = { scope = "axis", type = "whole", en = "x", initial = 0.5 })", "initial must be a whole number"},
      {R"("0100" = { scope = "axis", type = "real", en = "x", used = 1 })", "used must be true or false"},
      {R"("0100" = { scope = "axis", type = "real", en = "x", bits = "A" })", "bits, but the type is not bits"},
      {R"("0100" = { scope = "axis", type = "bits", en = "x", bits = "A - A" })", "bits: 'A' twice"},
      {R"("0100" = { scope = "axis", type = "bits", en = "x", bits = "A | B | C" })", "bits: at most eight names"},
      {R"("0100" = { scope = "axis", type = "bits", en = "x", bits = "A B C D E F G H I | J" })", "bits: at most eight names"},
      {R"("100" = { scope = "axis", type = "real", en = "x" })", "'100': a parameter is named by four digits"},
      {R"("X100" = { scope = "axis", type = "real", en = "x" })", "'X100': a parameter is named by"},
      {R"("0100" = 1)", "a parameter is a table"},
      {R"("0100" = { scope)", ""},
  };
  for (const auto& c : cases) {
    const auto rows = parse_parameters(std::string("# head\n") + c.toml + "\n", "own-parameters.toml");
    ASSERT_FALSE(rows) << c.toml;
    EXPECT_EQ(rows.error().find(std::string("own-parameters.toml:2:") + (*c.sentence == 0 ? "17: " : " ") + c.sentence), 0u)
        << rows.error();
  }
}

}  // namespace
}  // namespace kadr::parameter_table_test
