// config/setup/setup_events: what the machine's logic does at an event, and when. tests/golden/README.md, "Events".

#include <gtest/gtest.h>

#include "config/setup/setup.h"

namespace kadr::setup_events_test {
namespace {

using When = SetupEvent::When;
using Do = SetupEvent::Do;

SetupEvent event(const std::string& json) {
  auto setup = parse_setup(R"({"events": [)" + json + "]}");
  EXPECT_TRUE(setup) << setup.error();
  return setup && setup->events.size() == 1 ? setup->events[0] : SetupEvent{};
}

std::string refusal(const std::string& json) {
  const auto setup = parse_setup(R"({"events": [{"when": {"program": "end"}, "do": "start"}, )" + json + "]}");
  EXPECT_FALSE(setup) << json;
  return setup ? "" : setup.error();
}

TEST(setup_events, when) {
  const SetupEvent start = event(R"({"when": {"block": "N30", "at": "start"}, "do": "start"})");
  EXPECT_EQ(start.when, When::block_start);
  EXPECT_EQ(start.block, "N30");
  EXPECT_EQ(event(R"({"when": {"block": ":5", "at": "end"}, "do": "start"})").when, When::block_end);
  EXPECT_EQ(event(R"({"when": {"block": "N30"}, "do": "start"})").when, When::block_start);
  const SetupEvent code = event(R"({"when": {"code": "M90", "count": 3}, "do": "start"})");
  EXPECT_EQ(code.when, When::code);
  EXPECT_EQ(code.code, "M90");
  EXPECT_EQ(code.count, 3);
  EXPECT_EQ(event(R"({"when": {"code": "M21"}, "do": "start"})").count, 0);
  EXPECT_EQ(event(R"({"when": {"action": "stop"}, "do": "start"})").when, When::stop);
  EXPECT_EQ(event(R"({"when": {"action": "message"}, "do": "start"})").when, When::message);
  EXPECT_EQ(event(R"({"when": {"program": "end"}, "do": "power_cycle"})").when, When::program_end);
}

TEST(setup_events, what) {
  const std::string when = R"({"when": {"code": "M21"}, "do": )";
  const SetupEvent set = event(when + R"("set", "signal": "CP_MINT", "value": 1})");
  EXPECT_EQ(set.what, Do::set);
  EXPECT_EQ(set.signal, "CP_MINT");
  EXPECT_EQ(set.value, 1);
  const SetupEvent skip = event(when + R"("skip", "switch": 8, "on": true})");
  EXPECT_EQ(skip.what, Do::skip);
  EXPECT_EQ(skip.switch_number, 8);
  EXPECT_TRUE(skip.on);
  EXPECT_EQ(event(when + R"("answer", "answer": "cancel"})").answer, "cancel");
  const SetupEvent coupled = event(when + R"("synchronise", "spindle": 2, "master": 1})");
  EXPECT_EQ(coupled.what, Do::synchronise);
  EXPECT_EQ(coupled.spindle, 2);
  EXPECT_EQ(coupled.master, 1);
  EXPECT_EQ(event(when + R"("synchronise", "axes": ["V", "W"]})").axes, (std::vector<std::string>{"V", "W"}));
  EXPECT_EQ(event(when + R"("release", "axis": "V"})").axes, (std::vector<std::string>{"V"}));
  EXPECT_EQ(event(when + R"("power_cycle"})").what, Do::power_cycle);
  EXPECT_EQ(event(when + R"("spindle_to_axis", "spindle": 1})").what, Do::spindle_to_axis);
  EXPECT_EQ(event(when + R"("axis_to_spindle", "spindle": 1})").what, Do::axis_to_spindle);
}

TEST(setup_events, wrong_forms) {
  const std::string one = "setup key 'events[1].when' must be one of {block, at}, {code, count}, {action}, {program}";
  EXPECT_EQ(refusal(R"({"when": {}, "do": "start"})"), one);
  EXPECT_EQ(refusal(R"({"when": {"block": "N1", "code": "M1"}, "do": "start"})"), one);
  EXPECT_EQ(refusal(R"({"when": {"code": "M1", "at": "end"}, "do": "start"})"), one);
  EXPECT_EQ(refusal(R"({"when": {"block": "N1", "count": 2}, "do": "start"})"), one);
  EXPECT_EQ(refusal(R"({"when": {"block": "30"}, "do": "start"})"), "setup key 'events[1].when.block' must be a block number, \"N30\"");
  EXPECT_EQ(refusal(R"({"when": {"code": 90}, "do": "start"})"), "setup key 'events[1].when.code' must be a text");
  EXPECT_EQ(refusal(R"({"do": "start"})"), "setup key 'events[1]' must be a table with 'when'");
  const std::string when = R"({"when": {"code": "M21"})";
  EXPECT_EQ(refusal(when + "}"), "setup key 'events[1]' must be a table with 'do'");
  EXPECT_EQ(refusal(when + R"(, "do": "jump"})"),
            "setup key 'events[1].do' must be \"set\", \"skip\", \"start\", \"answer\", \"power_cycle\", \"synchronise\", \"release\", "
            "\"spindle_to_axis\", \"axis_to_spindle\", \"exchange\", \"reverse\" or \"park\"");
  EXPECT_EQ(refusal(when + R"(, "do": "set", "value": 1})"), "setup key 'events[1]' must be a table with 'signal'");
  EXPECT_EQ(refusal(when + R"(, "do": "skip", "switch": 1})"), "setup key 'events[1]' must be a table with 'on'");
  EXPECT_EQ(refusal(when + R"(, "do": "answer"})"), "setup key 'events[1]' must be a table with 'answer'");
  EXPECT_EQ(refusal(when + R"(, "do": "synchronise", "spindle": 2})"), "setup key 'events[1]' must be a table with 'master'");
  EXPECT_EQ(refusal(R"({"wen": {}})"), "unknown setup key 'events[1].wen'; did you mean 'when'?");
}

}  // namespace
}  // namespace kadr::setup_events_test
