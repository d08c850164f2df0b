// out/text/explain/code_page, out/text/explain/control_page, out/text/explain/variable_text: the explanation of a table row in kadr
// explain.

#include "out/text/explain/code_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/control/control_file.h"

namespace kadr::code_page_test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Explained : public testing::Test {
 protected:
  std::string of(const std::string& what, Lang lang = Lang::en) const { return explain_code(def, texts, what, lang).value_or("nothing"); }
  const ControlDef def = load_control("nct").value();
  const AlarmTexts texts = AlarmTexts::load(&def).value();
};

TEST_F(Explained, alarms_by_the_controls_number) {
  EXPECT_THAT(of("2012"), StartsWith("2012 radius_mismatch: Radius difference error in circle\n  Ошибка разности радиуса в окружности\n"));
  EXPECT_THAT(of("2012", Lang::ru), StartsWith("2012 radius_mismatch: Ошибка разности радиуса в окружности\n  Radius difference"));
  EXPECT_THAT(of("2121"), HasSubstr("terminator_wrong"));  // lists all alarms with this number
  EXPECT_THAT(of("2121"), HasSubstr("bracket_not_closed"));
  EXPECT_EQ(of("radius_mismatch") + of("radius_too_small"), of("2012"));
  EXPECT_EQ(of("9999"), "nothing");
}

TEST_F(Explained, variables_by_number_and_symbol) {
  EXPECT_THAT(of("#5021"), StartsWith("nct #5021 #_ABSMT[1]: "));
  EXPECT_THAT(of("#100052"), StartsWith("nct #100052 #_ABSMT[2]: "));
  EXPECT_THAT(of("#1005"), StartsWith("nct #1005 #_UI[5]: "));
  EXPECT_THAT(of("#7030"), StartsWith("nct #7030 #_WZP2[10]: "));
  EXPECT_THAT(of("ABSIO"), HasSubstr("numbers: #5001–#5020, #100001–#100050\n"));
  EXPECT_EQ(of("#_ABSIO[3]"), of("absio"));
  EXPECT_EQ(of("WZP7"), of("#_WZP8[1]"));
  EXPECT_THAT(of("#_TEST"), HasSubstr("bit 1 of #_CNTBS"));
  EXPECT_THAT(of("#_ALM"), HasSubstr("write only"));
  for (const char* const none : {"#6000", "#", "#_", "#5021x", "ABSIO7", "#99999999999"}) EXPECT_EQ(of(none), "nothing") << none;
}

TEST_F(Explained, a_letter_is_an_address_before_a_symbol) {
  EXPECT_THAT(of("E"), HasSubstr("format"));
  EXPECT_THAT(of("#_E"), HasSubstr("#3102"));
}

TEST_F(Explained, codes_that_do_not_work_yet) {
  EXPECT_THAT(of("G51.2"), HasSubstr("not in this version"));
  EXPECT_THAT(of("G51.2"), HasSubstr("words: P Q R\n"));
  EXPECT_THAT(of("G43"), Not(HasSubstr("not in this version")));
}

TEST_F(Explained, page_has_codes_variables_and_alarms) {
  const std::string page = control_page(def, texts);
  EXPECT_THAT(page, HasSubstr("| code | group | lasts | words | works | meaning |"));
  EXPECT_THAT(page, HasSubstr("| #5021–#5040, #100051–#100100 | #_ABSMT[1–50] | R | yes |"));
  EXPECT_THAT(page, HasSubstr("| 2012 | `radius_mismatch` | Radius difference error in circle | Ошибка разности радиуса в окружности |"));
  const ControlDef plain = load_control("gost").value();
  EXPECT_THAT(control_page(plain, AlarmTexts::load(&plain).value()), Not(HasSubstr("| works |")));
}

}  // namespace
}  // namespace kadr::code_page_test
