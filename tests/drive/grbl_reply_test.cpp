// The lines of a controller of the Grbl family, as values; and the settings that they state.

#include "drive/grbl/grbl_reply.h"

#include <gtest/gtest.h>

#include "drive/grbl/grbl_settings.h"

namespace kadr::drive::grbl_reply_test {

template <class Wanted>
Wanted as(std::string_view line) {
  const GrblReply reply = grbl_reply(line);
  const auto* const found = std::get_if<Wanted>(&reply);
  EXPECT_NE(found, nullptr) << line << " is of kind " << reply.index();
  return found != nullptr ? *found : Wanted{};
}

TEST(GrblReply, ReadsAnswersAndAlarms) {
  as<GrblOk>("ok");
  EXPECT_EQ(as<GrblError>("error:20").code, 20);
  EXPECT_EQ(as<GrblAlarm>("ALARM:3").code, 3);
  EXPECT_EQ(as<GrblBanner>("Grbl 1.1h ['$' for help]").version, "1.1h");
  EXPECT_EQ(as<GrblBanner>("GrblHAL 1.1f ['$' or '$HELP' for help]").version, "1.1f");
  EXPECT_EQ(as<GrblBracket>("[MSG:Caution: Unlocked]").text, "Caution: Unlocked");
  EXPECT_EQ(as<GrblStartup>(">G54G20:ok").text, "G54G20:ok");
  EXPECT_EQ(as<GrblSetting>("$110=500.000").value, 500);
  EXPECT_EQ(as<GrblSetting>("$0=10 (step pulse, usec)").value, 10);
}

TEST(GrblReply, ReadsStatusReports) {
  const auto report =
      as<GrblReport>("<Hold:1|MPos:-1.500,2.000,0.000,9.000|Bf:3,40|Ln:17|FS:500,8000|Pn:XZ|WCO:1.000,0.000,0.000|Ov:90,50,110>");
  EXPECT_EQ(report.state, GrblState::hold);
  EXPECT_EQ(report.substate, 1);
  EXPECT_EQ(report.machine, (GrblPoint{-1.5, 2, 0}));
  EXPECT_EQ(report.free, (GrblFree{3, 40}));
  EXPECT_EQ(report.line, 17U);
  EXPECT_EQ(report.feed, 500);
  EXPECT_EQ(report.speed, 8000);
  EXPECT_EQ(report.pins, "XZ");
  EXPECT_EQ(report.offset, (GrblPoint{1, 0, 0}));
  ASSERT_TRUE(report.overrides);
  EXPECT_EQ(report.overrides->rapid, 50);
}

TEST(GrblReply, TakesNothingElse) {
  for (const char* const line : {"o",
                                 "k",
                                 "okk",
                                 "ok ",
                                 "o*",
                                 "error:",
                                 "error:x",
                                 "error:-1",
                                 "ALARM:",
                                 "<Idel|MPos:0,0,0>",
                                 "<Idle|MPos:0,0>",
                                 "<Idle|MPos:0,0,x>",
                                 "<Idle>",
                                 "<Idle|MPos:0,0,0",
                                 "$=1",
                                 "$1=",
                                 "$1=x",
                                 "$1=nan",
                                 "<Hold:x|MPos:0,0,0>",
                                 "[]",
                                 "<>",
                                 "\x80"})
    as<GrblUnknown>(line);
}

TEST(GrblSettings, AreReadFromARecordedConversation) {
  const GrblSettings settings = grbl_settings_in(
      "Grbl 1.1h ['$' for help]\r\n$$\n$11=0.010\r\n$130=300.000\r\nok\r\n[G54:-100.000,-50.000,0.000]\r\n[G92:0.000,0.000,0.000]\r\n"
      "[TLO:1.500]\r\n[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]\r\n[VER:1.1h.20190830:]\r\n[OPT:V,35,1024]\r\nnoise");
  EXPECT_EQ(settings.value(130, 0), 300);
  EXPECT_EQ(settings.value(131, -1), -1);
  EXPECT_EQ(settings.offsets.at("G54"), (GrblPoint{-100, -50, 0}));
  EXPECT_EQ(settings.tool_length, 1.5);
  EXPECT_EQ(settings.modes, "G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0");
  EXPECT_EQ(settings.planner_blocks, 35);
  EXPECT_EQ(settings.buffer_bytes, 1024);
}

}  // namespace kadr::drive::grbl_reply_test
