// out/text/quick_fix: the correction of a line; after it the alarm is gone.

#include "out/text/quick_fix.h"

#include <gtest/gtest.h>

#include "config/control/control_file.h"
#include "config/machine/machine_profile.h"
#include "lang/text/utf16.h"
#include "session/checklist/checklist.h"
#include "session/session.h"

namespace kadr::quick_fix_test {
namespace {

/// Returns the first report of an alarm id in a program; the run continues after all faults.
std::optional<AlarmReport> first(const std::string& control, const std::string& text, AlarmId id) {
  const auto def = std::make_shared<const ControlDef>(load_control(control).value());
  auto session = Session::open({def, load_machine("generic").value(), {}, {"quick_fix_test", text_source(text), Encoding::utf8}, {}});
  std::optional<AlarmReport> found;
  const auto take = [&](const AlarmReport& report) {
    if (report.alarm.id == id && !found) found = report;
    return true;
  };
  (*session)->outlets().warning = [&](const AlarmReport& report) { (void)take(report); };
  (*session)->outlets().alarm = take;
  Checklist checklist(**session, 0);
  checklist.attach();
  (void)(*session)->run();
  for (const AlarmReport& advice : checklist.reports({})) (void)take(advice);
  return found;
}

std::string fixed(std::string line, const QuickFix& fix) { return line.replace(fix.from - 1, fix.to - fix.from, fix.insert); }

/// Returns the only line, which has the fault, after the correction; the fault must be gone then.
std::string mended(const std::string& control, const std::string& line, AlarmId id) {
  const auto report = first(control, line + "\nM30\n", id);
  if (!report) return "no such alarm";
  const auto fix = quick_fix(*report, Lang::en);
  if (!fix) return "no fix";
  const std::string text = fixed(line, *fix);
  EXPECT_FALSE(first(control, text + "\nM30\n", id)) << text;
  return text;
}

TEST(QuickFix, ClosesWhatIsOpen) {
  EXPECT_EQ(mended("mach3", "G1 F100 X[1+2", AlarmId::bracket_not_closed), "G1 F100 X[1+2]");
  EXPECT_EQ(mended("mach3", "G0 X1 (to the side ", AlarmId::comment_not_closed), "G0 X1 (to the side) ");
}

TEST(QuickFix, RemovesWhatIsTooMuch) { EXPECT_EQ(mended("mach3", "G1 X1 F100 X2", AlarmId::address_twice), "G1 X1 F100"); }

TEST(QuickFix, RemovesAWordThatNothingTakes) {
  EXPECT_EQ(mended("mach3", "G1 X1 Q7 F100", AlarmId::word_unused), "G1 X1 F100");
  EXPECT_EQ(mended("mach3", "Q7 G1 X1 F100", AlarmId::word_unused), "G1 X1 F100");
  EXPECT_EQ(mended("mach3", "G1 X1 Q[1+2] F100", AlarmId::word_unused), "no fix");
}

TEST(QuickFix, WritesLatinLetters) {
  const auto report = first("mach3",
                            "G0 \xD0\xA5"
                            "1\nM30\n",
                            AlarmId::look_alike_letter);
  ASSERT_TRUE(report);
  const auto fix = quick_fix(*report, Lang::ru);
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->insert, "X");
  EXPECT_EQ(fix->from, 4U);
  EXPECT_EQ(fix->to, 5U);
  EXPECT_EQ(fix->text, "Заменить на латинскую X");
}

/// Returns the line with the advice after the correction; the advice must be gone then.
std::string mended_in(const std::string& control, std::string text, AlarmId id) {
  const auto report = first(control, text, id);
  if (!report) return "no such advice";
  const auto fix = quick_fix(*report, Lang::en);
  if (!fix) return "no fix";
  const std::string line = fixed(report->line_text, *fix);
  text.replace(text.find(report->line_text), report->line_text.size(), line);
  EXPECT_FALSE(first(control, text, id)) << text;
  return line;
}

TEST(QuickFix, WritesAForgottenPoint) {
  EXPECT_EQ(mended_in("fanuc", "G21 G90 G54\nG0 X0. Y0. Z5.\nG1 Z-2. F100\nX50\nY50.\nG0 Z5.\nM30\n", AlarmId::point_forgotten), "X50.");
}

TEST(QuickFix, TurnsAnArcRound) {
  const std::string before = "G21 G90 G94 G54\nG0 X0 Y0 Z5\nG1 Z-2 F100\nG1 X50\n", after = "G1 Y50\nG0 Z5\nM30\n";
  EXPECT_EQ(mended_in("mach3", before + "G2 X60 Y10 R10\n" + after, AlarmId::arc_against_neighbours), "G3 X60 Y10 R10");
}

TEST(QuickFix, ThereIsNoneWhereNothingIsCertain) {
  const auto report = first("mach3", "G2 X1 I5 F100\nM30\n", AlarmId::radius_mismatch);
  ASSERT_TRUE(report);
  EXPECT_FALSE(quick_fix(*report, Lang::en));
}

}  // namespace
}  // namespace kadr::quick_fix_test
