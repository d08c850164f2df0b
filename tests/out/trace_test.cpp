// out/trace/trace: the exact lines of a trace. tests/golden/README.md.

#include "out/trace/trace.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>

#include "actions.h"

namespace kadr::trace_test {
namespace {

using test::action;
using test::arc;
using test::straight;
using enum MotionKind;

const std::vector<std::string> names = {"X", "Y", "Z"};
const AxisRoles roles = AxisRoles::of(names, 0);

/// A writer that receives actions from a given start.
struct Tracing {
  TraceWriter& writer;
  ToolPosition at;
  void write(const Action& a, const MotionTime& time = {}) {
    writer.write(Step(roles, a, at, 0, time));
    at.take(a);
  }
};

std::string traced(const std::function<void(TraceWriter&)>& write, std::vector<double> points = {}) {
  std::FILE* const file = std::tmpfile();
  {
    TraceWriter writer(file, names, 0, std::move(points));
    write(writer);
    EXPECT_TRUE(writer.ok());
  }
  std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
  std::fclose(file);
  return text;
}

std::string traced_from(const ToolPosition& start, const std::function<void(Tracing&)>& write, std::vector<double> points = {}) {
  const auto begin = [&](TraceWriter& writer) {
    Tracing tracing{writer, start};
    write(tracing);
  };
  return traced(begin, std::move(points));
}

std::string line_of(const Action& a) {
  return traced_from({}, [&](Tracing& w) { w.write(a); });
}

template <class T>
std::string line_of_what(const T& what) {
  Action a{};
  a.origin = {3, 5, 10, true, false, 3, 0};
  a.what = what;
  return line_of(a);
}

TEST(trace, motions) {
  Motion m = straight(rapid, {1, -2.5, 0});
  m.machine = {101, 0, -0.0};
  EXPECT_EQ(line_of(action(m, 7)), R"({"do":"rapid","line":7,"col":1,"to":{"X":1,"Y":-2.5,"Z":0},"machine":{"X":101,"Y":0,"Z":0}})"
                                   "\n");
  m = straight(feed, {0.1 + 0.2, -1e-12, 0}, 120);
  m.exact = true;
  EXPECT_EQ(line_of_what(m), R"({"do":"feed","block":"N010","line":3,"col":5,"to":{"X":0.3,"Y":0,"Z":0},"machine":{"X":0.3,"Y":0,"Z":0},)"
                             R"("feed":120,"unit":"mm/min","exact":true})"
                             "\n");
}

TEST(trace, arcs_name_their_plane_and_its_two_centres) {
  Motion m = arc(arc_cw, {10, 0, 0}, {5, 6, 7}, 0.5, Plane::zx);
  m.unit = FeedUnit::mm_per_rev;
  EXPECT_EQ(line_of(action(m)), R"({"do":"arc_cw","line":1,"col":1,"to":{"X":10,"Y":0,"Z":0},"machine":{"X":10,"Y":0,"Z":0},)"
                                R"("center":{"Z":7,"X":5},"plane":"ZX","turns":0.5,"feed":100,"unit":"mm/rev","exact":false})"
                                "\n");
}

TEST(trace, other_actions) {
  const std::string head = R"(","block":"N010","line":3,"col":5)";
  EXPECT_EQ(line_of_what(Dwell{2.5}), R"({"do":"dwell)" + head +
                                          R"(,"seconds":2.5})"
                                          "\n");
  EXPECT_EQ(line_of_what(Spindle{SpindleDir::ccw, 600}), R"({"do":"spindle)" + head +
                                                             R"(,"spindle":1,"dir":"ccw","rpm":600})"
                                                             "\n");
  EXPECT_EQ(line_of_what(Speed{700, false}), R"({"do":"speed)" + head +
                                                 R"(,"spindle":1,"rpm":700})"
                                                 "\n");
  EXPECT_EQ(line_of_what(CoolantSwitch{Coolant::flood}), R"({"do":"coolant)" + head +
                                                             R"(,"what":"flood","code":"M8"})"
                                                             "\n");
  EXPECT_EQ(line_of_what(ToolSelect{4, 0}), R"({"do":"tool)" + head +
                                                R"(,"tool":4})"
                                                "\n");
  EXPECT_EQ(line_of_what(ToolChange{4}), R"({"do":"toolchange)" + head +
                                             R"(,"tool":4})"
                                             "\n");
  EXPECT_EQ(line_of_what(MachineFunction{78}), R"({"do":"m)" + head +
                                                   R"(,"code":"M78"})"
                                                   "\n");
  EXPECT_EQ(line_of_what(Stop{false}), R"({"do":"stop)" + head + "}\n");
  EXPECT_EQ(line_of_what(Stop{true}), R"({"do":"optional_stop)" + head + "}\n");
  EXPECT_EQ(line_of_what(Message{"„Фреза\" \\ \x01"}), R"({"do":"message)" + head +
                                                           R"(,"text":"„Фреза\" \\ \u0001"})"
                                                           "\n");
  EXPECT_EQ(line_of_what(FrameChange{}), "");
  EXPECT_EQ(line_of_what(ZoneChange{}), "");
}

TEST(trace, other_actions_with_all_their_fields) {
  const auto fields = [](const std::string& line) {
    const std::string head = R"(","block":"N010","line":3,"col":5)";
    const std::size_t at = line.find(head);
    return line.substr(0, at) + line.substr(at + head.size());
  };
  EXPECT_EQ(fields(line_of_what(Spindle{SpindleDir::position, 0, 2, -90, 270})),
            R"({"do":"spindle,"spindle":2,"dir":"position","rpm":0,"turn":-90,"angle":270})"
            "\n");
  EXPECT_EQ(fields(line_of_what(Speed{1001, false, 3, 2})), "{\"do\":\"speed,\"spindle\":3,\"rpm\":1001,\"range\":2}\n");
  EXPECT_EQ(fields(line_of_what(Speed{120, true})), "{\"do\":\"speed,\"spindle\":1,\"surface_speed\":120}\n");
  EXPECT_EQ(fields(line_of_what(ToolSelect{10012, 4, {2, 1, 12}})),
            R"({"do":"tool,"tool":10012,"corrector":4,"data":2,"magazine":1,"pocket":12})"
            "\n");
  EXPECT_EQ(fields(line_of_what(ToolChange{555, {9, 0, 0}})), "{\"do\":\"toolchange,\"tool\":555,\"data\":9}\n");
  EXPECT_EQ(fields(line_of_what(MachineFunction{24, 1.5, {}, 2})), "{\"do\":\"m,\"code\":\"M24\",\"P\":1.5,\"spindle\":2}\n");
  EXPECT_EQ(fields(line_of_what(AuxiliaryFunction{'B', 45})), "{\"do\":\"aux,\"address\":\"B\",\"value\":45}\n");
  EXPECT_EQ(fields(line_of_what(Stop{false, StopReason::single_block})), "{\"do\":\"stop,\"reason\":\"single_block\"}\n");
  EXPECT_EQ(fields(line_of_what(Stop{true, StopReason::optional})), "{\"do\":\"optional_stop}\n");
  EXPECT_EQ(fields(line_of_what(Message{"ok", 0})), "{\"do\":\"message,\"number\":0,\"text\":\"ok\"}\n");
  EXPECT_EQ(fields(line_of_what(Sync{501, {2, 1}, 3})), "{\"do\":\"sync,\"code\":\"M501\",\"channels\":[2,1],\"at\":3}\n");
}

Motion with(Motion m, const MotionDetail& detail) {
  m.detail = std::make_shared<MotionDetail>(detail);
  return m;
}

TEST(trace, what_few_motions_have) {
  MotionDetail detail;
  detail.rolled = 5;
  detail.travel = {-30, 0, 390};
  detail.has_programmed = true;
  detail.programmed = {7, 8, 9};
  detail.lead = 1.5;
  detail.start_angle = 180;
  detail.turn = -2880;
  detail.torque = 19.5;
  const std::string line = line_of(action(with(straight(thread, {1, 2, 3}), detail)));
  EXPECT_NE(
      line.find(
          R"("exact":false,"travel":{"X":-30,"Z":390},"programmed":{"X":7,"Y":8,"Z":9},"lead":1.5,"angle":180,"turn":-2880,"torque":19.5})"),
      std::string::npos)
      << line;
}

// nct 21.1, golden 21-2: the program does not determine where a probe stopped the motion.
TEST(trace, way_of_the_motion_behind_a_probe) {
  const auto named = [](Motion m, AxisMask axes) {
    m.named = axes;
    return action(m);
  };
  const std::string lines = traced_from({}, [&](Tracing& w) {
    w.write(named(straight(probe, {130, 0, 0}, 100), 1));
    w.write(named(straight(feed, {300, 100, 0}, 100), 3));
    w.write(named(straight(feed, {0, 0, 0}, 100), 3));
    w.write(named(straight(probe, {1, 0, 0}, 100), 1));
    w.write(named(straight(feed, {1, 0, 0}, 100), 0));
  });
  const std::size_t first = lines.find("travel"), second = lines.find("travel", first + 1);
  EXPECT_NE(lines.find(R"("travel":{"X":170,"Y":100})"), std::string::npos) << lines;
  EXPECT_NE(lines.find(R"("travel":{})"), std::string::npos) << lines;
  EXPECT_EQ(lines.find("travel", second + 1), std::string::npos) << lines;
}

TEST(trace, length_of_arcs_and_times_where_they_are_exact) {
  const auto line = [](const Motion& m, const MotionTime& time) { return traced_from({}, [&](Tracing& w) { w.write(action(m), time); }); };
  const Motion half = arc(arc_ccw, {-10, 0, 0}, {}, 0.5);
  EXPECT_NE(line(half, {31.4, 18.84, 100, 100, false}).find(R"("exact":false,"length":31.4})"), std::string::npos);
  EXPECT_NE(line(half, {31.4, 18.84, 100, 100, true}).find(R"("exact":false,"length":31.4,"seconds":18.84,"feed_max":100})"),
            std::string::npos);
  const Motion plain = straight(feed, {10, 0, 0}, 100);
  EXPECT_NE(line(plain, {10, 6, 100, 100, false}).find("\"exact\":false}"), std::string::npos);
  EXPECT_NE(line(plain, {10, 6, 100, 100, true}).find(R"("exact":false,"seconds":6,"feed_max":100})"), std::string::npos);
  EXPECT_NE(line(straight(rapid, {}), {0, 0, 0, 0, true}).find(R"("Z":0},"seconds":0})"), std::string::npos);
}

// 04-50: X is linear, Y is the rotary axis.
TEST(trace, points_of_polar_interpolation) {
  MotionDetail detail;
  detail.surface = PathSurface::polar;
  detail.flat_from = {50, 1};
  detail.flat_to = {-50, 1};
  detail.max_rotary_speed = 3600;
  const Motion m = with(straight(feed, {std::sqrt(2501), 178.854237, 0}, 1000), detail);
  const ToolPosition start{{std::sqrt(2501), 1.145763, 0}, {std::sqrt(2501), 1.145763, 0}};
  const auto point = [&](bool exact) {
    const std::string line = traced_from(start, [&](Tracing& w) { w.write(action(m), {100, 6, 1000, 1000, exact}); }, {0.5});
    const auto json = nlohmann::json::parse(line);
    EXPECT_EQ(json.at("length"), 100);
    EXPECT_EQ(json.at("programmed").at("X"), -50);
    EXPECT_EQ(json.at("programmed").at("Y"), 1);
    return json.at("points").at(0);
  };
  const auto there = point(true);
  EXPECT_NEAR(there.at("to").at("X"), 1, 1e-6);
  EXPECT_NEAR(there.at("to").at("Y"), 90, 1e-6);
  EXPECT_EQ(there.at("programmed").at("X"), 0);
  EXPECT_NEAR(there.at("feed"), 62.831853, 1e-6);
  EXPECT_FALSE(point(false).contains("feed"));
}

TEST(trace, block_numbers_as_written) {
  Action a = action(straight(rapid, {}));
  a.origin.has_block = true;
  a.origin.block = 0;
  a.origin.block_digits = 1;
  a.origin.main_block = true;
  EXPECT_NE(line_of(a).find(R"("block":":0")"), std::string::npos);
  a.origin.block = 12345;
  EXPECT_NE(line_of(a).find(R"("block":":12345")"), std::string::npos);
}

TEST(trace, points_within_a_motion) {
  Motion m = arc(arc_ccw, {-10, 0, 0}, {}, 0.5);
  m.machine[0] = 90;
  const std::string line = traced_from({{10, 0, 0}, {110, 0, 0}}, [&](Tracing& w) { w.write(action(m)); }, {0.5, 1});
  EXPECT_NE(line.find(R"(,"points":[{"part":0.5,"to":{"X":0,"Y":10,"Z":0},"machine":{"X":100,"Y":10,"Z":0}},{"part":1,"to":{"X":-10,)"),
            std::string::npos)
      << line;
}

TEST(trace, last_line) {
  FinalState ending;
  ending.position = {1, 2, 3};
  ending.variables = {{"#100", 2.5}};
  ending.watched_unset = {{"#101", true}};
  ending.modal = {"G1", "G90"};
  const std::string state =
      R"(,"position":{"X":1,"Y":2,"Z":3},"machine_position":{"X":0,"Y":0,"Z":0},"variables":{"#100":2.5,"#101":null},"modal":["G1","G90"]})"
      "\n";
  EXPECT_EQ(traced([&](TraceWriter& w) { w.finish(ending); }), R"({"do":"end")" + state);

  const std::string more = state.substr(0, state.size() - 2) + R"(,"state":{"H":1}})" + "\n";
  EXPECT_EQ(traced([&](TraceWriter& w) {
              w.set_channel(2);
              w.finish(ending, {R"({"H":1})", 0});
            }),
            R"({"do":"end","channel":2)" + more);

  ControlDef def;
  def.alarms[AlarmId::radius_mismatch] = {"2012", {"Radii {0} and {1}", "Радиусы {0} и {1}"}, {}};
  AlarmReport report;
  report.alarm = alarm(AlarmId::radius_mismatch, {}, 3.05, "x\"y");
  report.origin = {2, 4, 2, true, false, 1, 0};
  const AlarmTexts texts = AlarmTexts::load(&def).value();
  EXPECT_EQ(
      traced([&](TraceWriter& w) { w.finish(ending, report, texts, Lang::ru); }),
      R"({"do":"alarm","block":"N2","line":2,"col":4,"id":"radius_mismatch","number":2012,"text":"Радиусы 3.05 и x\"y","args":[3.05,"x\"y"])" +
          state);
}

TEST(trace, channels) {
  Action dwell{{}, Dwell{2}};
  dwell.origin.line = 4;
  EXPECT_EQ(traced_from({},
                        [&](Tracing& w) {
                          w.writer.set_channel(3);
                          w.write(dwell);
                          w.write({dwell.origin, Sync{501, {3, 1}, 2.5}});
                        }),
            R"({"do":"dwell","channel":3,"line":4,"seconds":2})"
            "\n"
            R"({"do":"sync","channel":3,"line":4,"code":"M501","channels":[3,1],"at":2.5})"
            "\n");
  AlarmReport report;
  report.alarm = alarm(AlarmId::channels_wait, {}, 1.0, "M501");
  const AlarmTexts texts = AlarmTexts::load(nullptr).value();
  const std::string last = traced([&](TraceWriter& w) {
    w.set_channel(1);
    w.finish({}, report, texts, Lang::en, {"", 2});
  });
  EXPECT_NE(last.find(R"("channel":1,"line":0,"alarm_channel":2,"id":"channels_wait")"), std::string::npos) << last;
}

std::string number(double value) {
  char text[32];
  return {text, put_number(text, value)};
}

TEST(numbers, as_json_wants_them) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(-4e-10), "0");
  EXPECT_EQ(number(-6e-10), "-0.000000001");
  EXPECT_EQ(number(120.5), "120.5");
  EXPECT_EQ(number(1234567.123456789), "1234567.123456789");
  EXPECT_EQ(number(0.999999999999), "1");
  EXPECT_EQ(number(5e6 + 0.125), "5000000.125");
  EXPECT_EQ(number(1e300), "1e+300");
  EXPECT_EQ(number(std::nan("")), "null");
}

RC_GTEST_PROP(numbers, read_back_within_half_of_a_billionth, (int whole, int part)) {
  const double value = whole % 4'000'000 + part * 1e-9;
  const std::string text = number(value);
  RC_ASSERT(std::abs(std::strtod(text.c_str(), nullptr) - value) <= 0.51e-9 + 1e-15 * std::abs(value));
  RC_ASSERT(text.find('.') == std::string::npos || text.back() != '0');
}

TEST(trace, every_line_is_json) {
  std::string text = traced_from({}, [](Tracing& w) {
    for (int i = 0; i < 3000; ++i) w.write(action(straight(feed, {i * 0.1, i / 3.0, -i * 1e-5}, 100), unsigned(i)));
  });
  std::size_t lines = 0;
  for (std::size_t at = 0; at < text.size(); ++lines) {
    const std::size_t end = text.find('\n', at);
    ASSERT_EQ(nlohmann::json::parse(text.substr(at, end - at)).at("line"), lines);
    at = end + 1;
  }
  EXPECT_EQ(lines, 3000U);
}

}  // namespace
}  // namespace kadr::trace_test
