// base/alarm: ids and their names, arguments cut at a whole character.

#include "base/alarm.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace kadr::alarm_test {
namespace {

TEST(alarm_names, lead_back_to_their_ids) {
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < static_cast<std::size_t>(AlarmId::count); ++i) {
    const auto id = static_cast<AlarmId>(i);
    EXPECT_EQ(alarm_named(name_of(id)), id) << name_of(id);
    EXPECT_TRUE(seen.insert(name_of(id)).second) << name_of(id) << " twice";
  }
}

TEST(alarm_names, others_are_none) {
  for (const char* name : {"", "count", "parity", "Parity_error", "parity_error "}) EXPECT_EQ(alarm_named(name), no_alarm) << name;
}

TEST(alarm_arguments, are_numbers_or_text) {
  EXPECT_TRUE(AlarmArg(2.5).is_number());
  EXPECT_EQ(AlarmArg(2.5).number(), 2.5);
  EXPECT_FALSE(AlarmArg('X').is_number());
  EXPECT_EQ(AlarmArg('X').text(), "X");
  EXPECT_EQ(AlarmArg("G2").text(), "G2");
  EXPECT_EQ(AlarmArg().text(), "");
}

TEST(alarm_arguments, of_thirty_bytes_are_whole) {
  const std::string thirty(30, 'a');
  EXPECT_EQ(AlarmArg(thirty).text(), thirty);
  EXPECT_EQ(AlarmArg(thirty + "b").text(), thirty);
}

TEST(alarm_arguments, are_cut_at_a_whole_character) {
  std::string fifteen;
  for (int i = 0; i < 15; ++i) fifteen += "Ж";  // 15 letters, 30 bytes
  EXPECT_EQ(AlarmArg(fifteen).text(), fifteen);
  EXPECT_EQ(AlarmArg(fifteen + "Ж").text(), fifteen);
  EXPECT_EQ(AlarmArg("a" + fifteen).text(), "a" + fifteen.substr(0, 28));  // the 15th letter would end at byte 31, one too many
  const std::string signs = "a№№№№№№№№№№";                                 // three bytes each
  EXPECT_EQ(AlarmArg(signs).text(), signs.substr(0, 28));
}

TEST(alarms, carry_their_place_and_arguments) {
  const Alarm a = alarm(AlarmId::too_many_digits, {3, 7}, 'X', 8.0, 7.0);
  EXPECT_EQ(a.id, AlarmId::too_many_digits);
  EXPECT_EQ(a.severity, Severity::alarm);
  EXPECT_EQ(a.where, (Span{3, 7}));
  EXPECT_EQ(a.arg_count, 3);
  EXPECT_EQ(a.args[0].text(), "X");
  EXPECT_EQ(a.args[2].number(), 7);
  EXPECT_EQ(warning(AlarmId::feed_limited, {}).severity, Severity::warning);
  EXPECT_EQ(warning(AlarmId::feed_limited, {}).arg_count, 0);
}

}  // namespace
}  // namespace kadr::alarm_test
