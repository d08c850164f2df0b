// out/text/explain/name_text: names of statements and cycles with their parameters.

#include "out/text/explain/name_text.h"

#include <gtest/gtest.h>

#include "config/control/control_file.h"

namespace kadr {
namespace {

const ControlDef& control() {
  static const ControlDef def = *load_control("sinumerik");
  return def;
}

TEST(name_text, names_every_parameter_by_its_position) {
  const auto text = explain_name(control(), "cycle81", Lang::en);
  ASSERT_TRUE(text);
  EXPECT_NE(text->find("CYCLE81(RTP, RFP, SDIS, DP, DPR, DTB, _GMODE, _DMODE, _AMODE)"), std::string::npos);
  EXPECT_NE(text->find(" 3  SDIS"), std::string::npos);
}

TEST(name_text, has_both_languages_for_every_name_and_parameter) {
  for (const NameRow& row : named_rows(control())) {
    EXPECT_FALSE(row.text.en.empty() || row.text.ru.empty()) << row.name;
    for (const NameParameter& p : row.parameters) EXPECT_FALSE(p.text.en.empty() || p.text.ru.empty()) << row.name << " " << p.name;
  }
}

TEST(name_text, finds_the_arguments_of_a_cycle) {
  const std::string line = "MCALL CYCLE81(5,,2*(1+1),\"a,b\")";
  std::string found;
  each_part(control(), line, {0, std::uint32_t(line.size())}, [&](const StatementPart& part) {
    found += part.code + ":" + line.substr(part.where.begin, part.where.end - part.where.begin) + " ";
  });
  EXPECT_EQ(found, "MCALL:MCALL CYCLE81:CYCLE81 RTP:5 SDIS:2*(1+1) DP:\"a,b\" ");
}

TEST(name_text, is_nothing_for_a_control_without_names) { EXPECT_FALSE(explain_name(*load_control("fanuc"), "CYCLE81", Lang::en)); }

}  // namespace
}  // namespace kadr
