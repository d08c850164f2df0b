// out/text/alarm_print: prints alarms as text, as JSON and as SARIF 2.1.0.

#include "out/text/alarm_print.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "out/text/source_line.h"

namespace kadr::alarm_print_test {
namespace {

AlarmTexts texts() {
  ControlDef def;
  def.alarms[AlarmId::radius_mismatch] = {"2012", {"Radii {0} and {1}", "Радиусы {0} и {1}"}, {"Check I and J", "Проверьте I и J"}};
  return AlarmTexts::load(&def).value();
}

AlarmReport report() {
  AlarmReport r;
  r.alarm = alarm(AlarmId::radius_mismatch, {20, 25}, 3.05, 6.82);
  r.file = "дет 1.nc";
  r.line_text = "N2 (дуга)\tG02 X5 I0 J3";  // G02 begins after 5 + 8 + 2 bytes
  r.alarm.where = {14, 17};
  r.origin = {2, 1, 2, true, false, 1, 1};
  r.calls = {{"L02", 10, 100, true}, {"H3", 15, 0, false}};
  return r;
}

TEST(alarm_print, text_with_the_place_marked) {
  EXPECT_EQ(alarm_text(report(), texts(), Lang::en),
            "дет 1.nc:2:11: alarm radius_mismatch: Radii 3.05 and 6.82 [2012]\n"
            "  N2 (дуга)\tG02 X5 I0 J3\n"
            "           \t^~~\n"
            "  hint: Check I and J\n"
            "  called H3 in line 15\n"
            "  called L02 in line 10 N100\n");
  const std::string russian = alarm_text(report(), texts(), Lang::ru);
  EXPECT_NE(russian.find(":2:11: ошибка radius_mismatch: Радиусы 3.05 и 6.82 [2012]\n"), std::string::npos);
  EXPECT_NE(russian.find("  подсказка: Проверьте I и J\n"), std::string::npos);
  AlarmReport w = report();
  w.alarm.severity = Severity::warning;
  EXPECT_NE(alarm_text(w, texts(), Lang::en).find(": warning radius_mismatch: "), std::string::npos);
}

TEST(alarm_print, mark_at_the_end_and_on_nothing) {
  EXPECT_EQ(marked_line("G1 X", {4, 4}), "  G1 X\n      ^\n");
  EXPECT_EQ(marked_line("", {0, 0}), "  \n  ^\n");
  EXPECT_EQ(marked_line("G1\r\n", {0, 2}), "  G1\n  ^~\n");
}

TEST(alarm_print, long_lines_are_clipped_around_the_place) {
  const std::string line = std::string(5000, 'a') + "XX" + std::string(5000, 'b');
  const std::string text = marked_line(line, {5000, 5002});
  const std::size_t end = text.find('\n');
  EXPECT_LT(text.size(), 300U);
  EXPECT_TRUE(text.starts_with("  …aaa"));
  EXPECT_EQ(text.substr(end - 3, 3), "…");
  // The ellipsis is one column: three bytes in the text line, one blank in the line of the mark.
  EXPECT_EQ(text.find("^~") - end - 1, text.find("XX") - 2);
}

TEST(alarm_print, control_characters_do_not_reach_the_terminal) { EXPECT_EQ(marked_line("a\x1b[2Jb\x7f", {1, 2}), "  a␛[2Jb␡\n   ^\n"); }

TEST(alarm_print, json) {
  const auto all = nlohmann::json::parse(findings_json({finding_of(report(), texts(), Lang::en)}));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].at("column"), 11);
  EXPECT_EQ(all[0].at("end_column"), 14);
  EXPECT_EQ(all[0].at("severity"), "alarm");
  EXPECT_EQ(all[0].at("block"), "N2");
  EXPECT_EQ(all[0].at("number"), "2012");
  EXPECT_EQ(nlohmann::json::parse(findings_json({})).size(), 0U);
}

// The elements that SARIF 2.1.0 requires of a log: 3.13, 3.14, 3.18, 3.19, 3.27.
TEST(alarm_print, sarif) {
  AlarmReport other = report();
  other.alarm = warning(AlarmId::look_alike_letter, {0, 2}, "С", "C");
  const auto log = nlohmann::json::parse(findings_sarif(
      {finding_of(report(), texts(), Lang::en), finding_of(other, texts(), Lang::en), finding_of(report(), texts(), Lang::en)},
      {"0.1.0", 2, {{"folder/no.nc", "Permission denied"}}}));
  EXPECT_EQ(log.at("version"), "2.1.0");
  EXPECT_TRUE(log.at("$schema").get<std::string>().ends_with("sarif-2.1.0.json"));
  const auto& run = log.at("runs").at(0);
  const auto& driver = run.at("tool").at("driver");
  EXPECT_EQ(driver.at("name"), "Kadr");
  ASSERT_EQ(driver.at("rules").size(), 2U);
  ASSERT_EQ(run.at("results").size(), 3U);
  const auto& invocation = run.at("invocations").at(0);
  EXPECT_EQ(invocation.at("executionSuccessful"), false);
  EXPECT_EQ(invocation.at("exitCode"), 2);
  const auto& unread = invocation.at("toolExecutionNotifications").at(0);
  EXPECT_EQ(unread.at("message").at("text"), "Permission denied");
  EXPECT_EQ(unread.at("locations").at(0).at("physicalLocation").at("artifactLocation").at("uri"), "folder/no.nc");
  for (const auto& result : run.at("results")) {
    EXPECT_EQ(driver.at("rules").at(result.at("ruleIndex").get<std::size_t>()).at("id"), result.at("ruleId"));
    EXPECT_FALSE(result.at("message").at("text").get<std::string>().empty());
    const auto& place = result.at("locations").at(0).at("physicalLocation");
    EXPECT_EQ(place.at("artifactLocation").at("uri"), "%D0%B4%D0%B5%D1%82%201.nc");
    EXPECT_GE(place.at("region").at("startColumn"), 1);
    EXPECT_GT(place.at("region").at("endColumn"), place.at("region").at("startColumn"));
  }
  EXPECT_EQ(run.at("results").at(0).at("level"), "error");
  EXPECT_EQ(run.at("results").at(1).at("level"), "warning");
}

}  // namespace
}  // namespace kadr::alarm_print_test
