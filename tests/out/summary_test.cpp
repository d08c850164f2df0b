// out/text/summary: the totals of a run.

#include "out/text/summary.h"

#include <gtest/gtest.h>

#include "actions.h"
#include "motion/time/steps.h"

namespace kadr::summary_test {
namespace {

using test::action;
using test::arc;
using test::straight;
using enum MotionKind;

/// Passes actions to the statistics as a run does, from a given start.
struct Counting {
  Counting(const std::vector<std::string>& axes, AxisMask rotary, const MachineProfile& profile, const ToolPosition& start = {})
      : roles(AxisRoles::of(axes, rotary)), s(axes, rotary, rates_of(profile, kadr::Setup{}, axes)), steps(roles, start, &s.clock()) {}
  MotionTime take(const Action& a) {
    MotionTime time;
    steps.give(a, [&](const Step& step) {
      s.consume(step);
      time = step.time;
    });
    return time;
  }
  AxisRoles roles;
  Statistics s;
  Steps steps;
};

Statistics run() {
  const std::vector<std::string> names = {"X", "Y", "Z"};
  MachineProfile profile;
  profile.tool_change_s = 10;
  Counting run(names, 0, profile);
  run.take({{}, ToolChange{4}});
  run.take(action(straight(rapid, {100, 0, 0})));
  run.take(action(straight(feed, {100, 50, 0}, 100)));
  run.take(action(arc(arc_ccw, {80, 50, 0}, {90, 50, 0}, 0.5)));
  run.take({{}, Dwell{2}});
  run.s.count(Severity::warning);
  return run.s;
}

TEST(summary, counts_lengths_and_extents) {
  const Statistics s = run();
  EXPECT_EQ(s.rapids(), 1U);
  EXPECT_EQ(s.feeds(), 1U);
  EXPECT_EQ(s.arcs(), 1U);
  EXPECT_DOUBLE_EQ(s.rapid_mm(), 100);
  EXPECT_DOUBLE_EQ(s.cutting_mm(), 50 + 10 * pi);
  EXPECT_EQ(s.cutting_box().most, (Vec3{100, 60, 0}));
  EXPECT_EQ(s.cutting_box().least, (Vec3{80, 0, 0}));
  EXPECT_EQ(s.box().least, (Vec3{0, 0, 0}));
  ASSERT_EQ(s.tools().size(), 1U);
  EXPECT_DOUBLE_EQ(s.tools()[0].cutting_s, s.time().cutting);
}

TEST(summary, text_in_both_languages) {
  const std::string english = run().text(6, Lang::en);
  EXPECT_EQ(english,
            "blocks          6\n"
            "motions         3 (rapid 1, feed 1, arcs 1)\n"
            "path, mm        cutting 81.416, rapid 100\n"
            "cutting, mm     X 80 … 100   Y 0 … 60   Z 0 … 0\n"
            "all, mm         X 0 … 100   Y 0 … 60   Z 0 … 0\n"
            "time            1:01.4 (cutting 0:48.8, rapid 0:00.6, dwell 0:02.0, tool change 0:10.0)\n"
            "                from programmed feeds and rapid rates, without acceleration\n"
            "tools           T4 (cutting 0:48.8)\n"
            "alarms          0, warnings 1\n");
  EXPECT_NE(run().text(6, Lang::ru).find("без разгонов"), std::string::npos);
}

Statistics moved(const std::vector<Motion>& motions, AxisMask rotary = 0) {
  const std::vector<std::string> names = {"X", "Y", "Z", "A"};
  Counting run(names, rotary, {});
  for (const Motion& motion : motions) run.take(action(motion));
  return run.s;
}

Motion in_system(Motion motion, std::uint16_t system, bool inch = false) {
  motion.system = system;
  motion.inch = inch;
  return motion;
}

TEST(summary, extents_of_each_work_system_that_is_used) {
  Statistics s = moved({in_system(straight(feed, {10, 0, 0}, 100), 1), in_system(straight(rapid, {10, 0, 5}), 2),
                        in_system(straight(feed, {30, 0, 5}, 100), 2), in_system(straight(feed, {10, 4, 0}, 100), 1)});
  s.name_systems({"", "G54", "G55"});
  using Texts = std::vector<std::string>;
  // The last motion begins at X30 Z5, where the previous motion has ended.
  EXPECT_EQ(s.extents().texts(RunExtents::Of::cutting, {"", "G54", "G55"}),
            (Texts{"G54  X 0 … 30   Y 0 … 4   Z 0 … 5", "G55  X 10 … 30   Y 0 … 0   Z 5 … 5"}));
  EXPECT_EQ(s.extents().texts(RunExtents::Of::all, {"", "G54", "G55"}),
            (Texts{"G54  X 0 … 30   Y 0 … 4   Z 0 … 5", "G55  X 10 … 30   Y 0 … 0   Z 0 … 5"}));
  EXPECT_EQ(s.caption(Lang::en), "cutting, mm:  G54  X 0 … 30   Y 0 … 4   Z 0 … 5;   G55  X 10 … 30   Y 0 … 0   Z 5 … 5");
}

TEST(summary, the_unit_is_that_of_the_cutting) {
  const Motion fast = straight(rapid, {25.4, 0, 0}), slow = straight(feed, {50.8, 0, 0}, 100);
  EXPECT_EQ(moved({in_system(fast, 0, false), in_system(slow, 0, true)}).extents().unit(), LengthUnit::inch);
  EXPECT_EQ(moved({in_system(fast, 0, true), in_system(slow, 0, false)}).extents().unit(), LengthUnit::mm);
  EXPECT_EQ(moved({in_system(slow, 0, true), in_system(slow, 0, false)}).extents().unit(), LengthUnit::mixed);
  EXPECT_EQ(moved({in_system(fast, 0, true)}).extents().unit(), LengthUnit::inch) << "nothing is cut";
  const std::string text = moved({in_system(fast, 0, true), in_system(slow, 0, true)}).text(2, Lang::en);
  EXPECT_NE(text.find("path, in        cutting 1, rapid 1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("cutting, in     X 1 … 2   Y 0 … 0   Z 0 … 0\n"), std::string::npos) << text;
}

TEST(summary, rotary_axes_have_ranges_in_degrees) {
  Motion turns = straight(feed, {10, 0, 0}, 100);
  turns.to[3] = 90;
  turns.inch = true;
  EXPECT_NE(moved({turns}, 8).text(1, Lang::en).find("Z 0 … 0   A 0 … 90°\n"), std::string::npos);
  EXPECT_EQ(moved({straight(feed, {10, 0, 0}, 100)}, 8).text(1, Lang::en).find('A'), std::string::npos) << "it stands";
}

/// Returns the spindle's commands for a constant surface speed of 180 m/min, X the radius.
std::vector<Action> surface_speed(double most_rpm) {
  SurfaceSpeed law;
  law.on = true;
  law.metres = 180;
  law.most = most_rpm;
  return {{{}, Spindle{SpindleDir::cw, 1000, 1, {}, {}}}, {{}, law}};
}

Motion diameters(Motion m) {
  m.diameters = 1;
  return m;
}

// A lathe has no Y, and X is shown as it is programmed; the path is a true length.
TEST(summary, a_lathe_shows_diameters_and_no_y) {
  Counting run({"X", "Z"}, 0, {});
  run.take(action(diameters(straight(rapid, {32, 2, 0}))));
  run.take(action(diameters(straight(feed, {-0.8, 2, 0}, 100))));
  const std::string text = run.s.text(3, Lang::en);
  EXPECT_NE(text.find("path, mm        cutting 32.8, rapid 32.062\n"
                      "cutting, mm     X -1.6 … 64   Z 2 … 2\n"
                      "all, mm         X -1.6 … 64   Z 0 … 2\n"
                      "                X is a diameter\n"),
            std::string::npos)
      << text;
  EXPECT_NE(run.s.text(3, Lang::ru).find("X — диаметр\n"), std::string::npos);
  EXPECT_EQ(run.s.caption(Lang::en), "cutting, mm:  X -1.6 … 64   Z 2 … 2;   X is a diameter");
  EXPECT_EQ(run.s.cutting_box().most.x, 32) << "the boxes are true lengths";
}

TEST(summary, radii_are_shown_if_a_cut_is_programmed_so) {
  Counting run({"X", "Z"}, 0, {});
  run.take(action(diameters(straight(feed, {10, 0, 0}, 100))));
  run.take(action(straight(feed, {20, 0, 0}, 100)));
  EXPECT_EQ(run.s.caption(Lang::en), "cutting, mm:  X 0 … 20   Z 0 … 0");
}

// n = 1000 v / (π D), at most the limit: 180 m/min from D 64 to the centre.
TEST(summary, spindle_speeds_at_constant_surface_speed) {
  const auto line_of = [](double most_rpm, double to_radius) {
    Counting run({"X", "Z"}, 0, {}, {{32, 0}, {32, 0}});
    for (const Action& a : surface_speed(most_rpm)) run.take(a);
    run.take(action(straight(feed, {to_radius, 0, 0}, 100)));
    const std::string text = run.s.text(3, Lang::en);
    const std::size_t at = text.find("spindle ");
    return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_EQ(line_of(2500, -0.8), "spindle         895 … 2500 rev/min at constant surface speed");
  EXPECT_EQ(line_of(2500, 16), "spindle         895 … 1790 rev/min at constant surface speed");
  EXPECT_EQ(line_of(SurfaceSpeed::no_limit, 0), "spindle         895 rev/min and more at constant surface speed, without an upper limit");
  Counting without({"X", "Z"}, 0, {});
  without.take(action(straight(feed, {10, 0, 0}, 100)));
  EXPECT_EQ(without.s.text(1, Lang::en).find("spindle"), std::string::npos);
}

TEST(summary, durations) {
  EXPECT_EQ(duration_text(0), "0:00.0");
  EXPECT_EQ(duration_text(59.96), "1:00.0");
  EXPECT_EQ(duration_text(725), "12:05");
  EXPECT_EQ(duration_text(3725.4), "1:02:05");
}

TEST(summary, channels) {
  EXPECT_EQ(channel_heading(2, Lang::en), "channel 2\n");
  EXPECT_EQ(channels_text({{1, 50, 0}, {2, 20.5, 40}}, Lang::en),
            "machining time  1:00.5: channel 1 0:50.0, channel 2 1:00.5 (waiting 0:40.0)\n");
  EXPECT_EQ(channels_text({{1, 1, 2}}, Lang::ru), "время обработки 0:03.0: канал 1 0:03.0 (ожидание 0:02.0)\n");
}

TEST(summary, work_position_follows_the_frame) {
  const std::vector<std::string> names = {"X", "Y", "Z"};
  Counting run(names, 0, {});
  run.take({{}, FrameChange{{.origin = {100, 0, 0}}, {-100, 0, 0}}});
  run.take(action(straight(feed, {0, 0, 0}, 100)));
  EXPECT_DOUBLE_EQ(run.s.cutting_mm(), 100);
}

TEST(summary, threads_cut) {
  const std::vector<std::string> names = {"X", "Y", "Z"};
  Counting run(names, 0, {});
  Statistics& s = run.s;
  kadr::Setup setup;
  setup.tool = 1;
  setup.spindles[1].rpm = 100;
  s.start_with(setup);
  MotionDetail detail;
  detail.lead = 2;
  Motion m = straight(thread, {0, 0, -20});
  m.detail = std::make_shared<MotionDetail>(detail);
  EXPECT_DOUBLE_EQ(run.take(action(m)).seconds, 6);
  EXPECT_EQ(s.feeds(), 1U);
  EXPECT_DOUBLE_EQ(s.cutting_mm(), 20);
  EXPECT_EQ(s.cutting_box().least.z, -20);
  EXPECT_DOUBLE_EQ(s.tools()[0].cutting_s, 6);
}

TEST(summary, polar_interpolation_by_its_real_axes) {  // golden 04-50
  const std::vector<std::string> names = {"X", "C"};
  Counting run(names, 2, {}, {{50, 0}, {50, 0}});
  MotionDetail detail;
  detail.surface = PathSurface::polar;
  detail.flat_from = {50, 1};
  detail.flat_to = {-50, 1};
  Motion m = straight(feed, {50, 178, 0}, 1000);
  m.detail = std::make_shared<MotionDetail>(detail);
  run.take(action(m));
  EXPECT_DOUBLE_EQ(run.s.cutting_mm(), 100);
  EXPECT_NEAR(run.s.cutting_box().least.x, 1, 1e-9);
}

}  // namespace
}  // namespace kadr::summary_test
