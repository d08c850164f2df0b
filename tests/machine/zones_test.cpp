// machine/zones: zones that the axes must not enter. NCT 22. The slow reference of the geometry is the sampled path.

#include "machine/zones.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "random_motion.h"

namespace kadr::zones_test {
namespace {

using test::any_motion;
using test::any_number;
using test::arc;
using test::Moved;
using test::straight;
using enum MotionKind;

const std::vector<std::string> names = {"X", "Y", "Z"};
const AxisRoles roles = AxisRoles::of(names, 0);
constexpr double free_end = 1e300;

Extents no_ends() {
  Extents ends{};
  ends.least.fill(-free_end);
  ends.most.fill(free_end);
  return ends;
}

/// Returns a set-up with bits of N1001: "E" EXT, "S" STE, "C" CBM.
kadr::Setup bits(std::string_view set) {
  kadr::Setup setup;
  for (const auto& [letter, bit] : {std::pair{'E', "0"}, {'S', "1"}, {'C', "2"}})
    if (set.find(letter) != std::string_view::npos) setup.parameters[{"1001", "", bit}] = 1.0;
  return setup;
}

ZoneChange cube(double least, double most, bool outside) {
  ZoneChange zone{true, outside, 7, {}, {}};
  zone.least = {least, least, least};
  zone.most = {most, most, most};
  return zone;
}

/// Returns the name and the first argument of the alarm that a motion between two machine positions gives.
std::string checked(const Zones& zones, Vec3 from, Vec3 to) {
  const Axes start{from.x, from.y, from.z};
  const Status status = zones.check({start, start}, straight(feed, to));
  if (status) return "";
  const Alarm& alarm = status.error();
  return std::string(name_of(alarm.id)) + (alarm.arg_count > 0 ? " " + std::string(alarm.args[0].text()) : "");
}

Zones zones_of(const kadr::Setup& setup, const ZoneChange& zone, const Extents& ends = no_ends()) {
  Zones zones(names, roles, ends, setup);
  zones.change(zone);
  return zones;
}

TEST(zones, outside_forbidden_before_the_motion) {
  const Zones zones = zones_of(bits("C"), cube(0, 100, true));
  EXPECT_EQ(checked(zones, {50, 50, 50}, {150, 50, 50}), "zone2_positive X");
  EXPECT_EQ(checked(zones, {50, 50, 50}, {50, -1, 50}), "zone2_negative Y");
  EXPECT_EQ(checked(zones, {50, 50, 50}, {100, 0, 100}), "");                   // exactly at the limits
  EXPECT_EQ(checked(zones, {150, 50, 50}, {120, 50, 50}), "zone2_positive X");  // towards the zone, but not into it
  EXPECT_EQ(checked(zones, {150, 50, 50}, {90, 50, 50}), "");
}

TEST(zones, outside_forbidden_on_the_way) {
  const Zones zones = zones_of({}, cube(0, 100, true));
  EXPECT_EQ(checked(zones, {50, 50, 50}, {150, 50, 50}), "zone2_reached_positive X");
  EXPECT_EQ(checked(zones, {50, 50, 50}, {50, 50, -1}), "zone2_reached_negative Z");
  EXPECT_EQ(checked(zones, {150, 50, 50}, {120, 60, 50}), "");
  EXPECT_EQ(checked(zones, {150, 50, 50}, {151, 50, 50}), "zone2_reached_positive X");
}

TEST(zones, the_first_one_on_the_way_is_named) {
  const Zones zones = zones_of({}, cube(0, 100, true));
  EXPECT_EQ(checked(zones, {50, 50, 50}, {150, 260, 50}), "zone2_reached_positive Y");
  Extents ends = no_ends();
  ends.most = {80, 200, 200};
  EXPECT_EQ(checked(zones_of({}, cube(0, 100, true), ends), {50, 50, 50}, {150, 50, 50}), "zone1_reached_positive X");
  ends.most[0] = 120;
  EXPECT_EQ(checked(zones_of({}, cube(0, 100, true), ends), {50, 50, 50}, {150, 50, 50}), "zone2_reached_positive X");
  EXPECT_EQ(checked(zones_of(bits("C"), cube(0, 100, true), ends), {50, 50, 50}, {150, 50, 50}), "zone1_positive X");
}

TEST(zones, of_two_reached_at_once_the_first_axis_is_named) {
  const Zones zones = zones_of({}, cube(0, 100, true));
  for (const double bit : {-1e-13, 0.0, 1e-13}) {
    EXPECT_EQ(checked(zones, {50, 50 + bit, 50}, {150, 150 + bit, 50}), "zone2_reached_positive X");
    EXPECT_EQ(checked(zones, {150, 150 + bit, 50}, {151, 151, 50}), "zone2_reached_positive X");  // starts beyond both limits
  }
}

TEST(zones, what_is_written_acts_from_g23_on) {  // 22.2
  Zones zones(names, roles, no_ends(), {});
  EXPECT_EQ(checked(zones, {50, 50, 50}, {150, 50, 50}), "");
  ZoneChange written = cube(0, 100, true);
  written.of_parameters = true;
  zones.change(written);
  EXPECT_EQ(checked(zones, {50, 50, 50}, {150, 50, 50}), "zone2_reached_positive X");
  zones.change(ZoneChange{true, false, 0, {}, {}, true});  // CBM
  EXPECT_EQ(checked(zones, {50, 50, 50}, {150, 50, 50}), "zone2_positive X");
  zones.change(cube(0, 200, true));  // G22
  EXPECT_EQ(checked(zones, {50, 50, 50}, {150, 50, 50}), "");
  zones.change(written);
  EXPECT_EQ(checked(zones, {50, 50, 50}, {150, 50, 50}), "zone2_positive X");
}

TEST(zones, inside_forbidden) {
  const Zones before = zones_of(bits("C"), cube(0, 100, false)), after = zones_of({}, cube(0, 100, false));
  EXPECT_EQ(checked(before, {150, 50, 50}, {50, 50, 50}), "zone2_inside");
  EXPECT_EQ(checked(after, {150, 50, 50}, {50, 50, 50}), "zone2_reached_inside");
  EXPECT_EQ(checked(before, {150, 50, 50}, {-50, 50, 50}), "zone2_entry");
  EXPECT_EQ(checked(after, {150, 50, 50}, {-50, 50, 50}), "zone2_reached_inside");
  EXPECT_EQ(checked(before, {150, 150, 50}, {-50, 150, 50}), "");
  EXPECT_EQ(checked(before, {150, 50, 50}, {100, 50, 50}), "");    // up to the face
  EXPECT_EQ(checked(before, {150, 100, 50}, {-50, 100, 50}), "");  // along a face
  EXPECT_EQ(checked(before, {200, 0, 50}, {0, 200, 50}), "");      // past an edge
  EXPECT_EQ(checked(before, {199.99, 0, 50}, {0, 199.99, 50}), "zone2_entry");
  EXPECT_EQ(checked(before, {50, 50, 50}, {150, 50, 50}), "zone2_entry");  // it is inside already
}

TEST(zones, without_depth) {  // 22.2
  ZoneChange flat = cube(10, 10, false);
  EXPECT_EQ(checked(zones_of(bits("C"), flat), {0, 10, 10}, {20, 10, 10}), "");
  EXPECT_EQ(checked(zones_of(bits("C"), flat), {0, 10, 10}, {10, 10, 10}), "");
  flat.outside_forbidden = true;
  EXPECT_EQ(checked(zones_of(bits("C"), flat), {0, 0, 0}, {20, 10, 10}), "zone2_positive X");
  EXPECT_EQ(checked(zones_of(bits("C"), flat), {0, 0, 0}, {10, 10, 10}), "zone2_positive X");
  flat.most[0] = 50;  // only Y and Z have no depth: a line is allowed
  EXPECT_EQ(checked(zones_of(bits("C"), flat), {10, 10, 10}, {20, 10, 10}), "");
}

TEST(zones, a_limit_left_out_is_none) {
  ZoneChange half{true, false, 1, {}, {}};
  half.least[0] = -std::numeric_limits<double>::infinity();
  half.most[0] = 0;
  const Zones zones = zones_of(bits("C"), half);
  EXPECT_EQ(checked(zones, {10, 0, 0}, {1, 500, -900}), "");
  EXPECT_EQ(checked(zones, {10, 0, 0}, {-1, 500, -900}), "zone2_inside");
}

TEST(zones, of_the_parameters) {
  kadr::Setup setup = bits("ESC");
  setup.parameters[{"1000", "X", "RE2"}] = 1.0;
  setup.parameters[{"1000", "3", "1"}] = 1.0;
  setup.parameters[{"1006", "X", ""}] = 200.0;
  setup.parameters[{"1006", "Z", ""}] = 50.0;
  setup.parameters[{"1007", "", ""}] = -5.0;
  Zones zones(names, roles, no_ends(), setup);
  EXPECT_TRUE(zones.in_force());
  EXPECT_EQ(checked(zones, {}, {201, 0, 0}), "zone2_positive X");
  EXPECT_EQ(checked(zones, {}, {200, 999, 0}), "");  // Y is not checked
  EXPECT_EQ(checked(zones, {}, {0, 0, -6}), "zone2_negative Z");
  zones.change(cube(-1000, 1000, true));  // G22: the parameters' limits are ignored
  EXPECT_EQ(checked(zones, {}, {201, 0, 0}), "");
  zones.change({});  // G23: they are in force again
  EXPECT_EQ(checked(zones, {}, {201, 0, 0}), "zone2_positive X");
  zones.suspend(2, true);
  EXPECT_EQ(checked(zones, {}, {201, 0, 0}), "");
  setup.parameters[{"1001", "", "STE"}] = 0.0;
  setup.parameters.erase({"1001", "", "1"});
  EXPECT_FALSE(Zones(names, roles, no_ends(), setup).in_force());
}

TEST(zones, zone_3_begins_with_its_faces) {  // 22.3
  kadr::Setup setup = bits("C");
  setup.parameters[{"1000", "X", "2"}] = 1.0;
  setup.parameters[{"1000", "Y", "RE3"}] = 1.0;
  setup.machine["*"].zone3 = {{0, 100}};
  Zones zones(names, roles, no_ends(), setup);
  EXPECT_EQ(checked(zones, {150, 50, 0}, {50, 50, 0}), "zone3_inside");
  EXPECT_EQ(checked(zones, {150, 50, 0}, {100, 50, 0}), "zone3_inside");
  EXPECT_EQ(checked(zones, {150, 50, 0}, {100.001, 50, 0}), "");
  EXPECT_EQ(checked(zones, {150, 100, 0}, {-50, 100, 0}), "zone3_entry");
  EXPECT_EQ(checked(zones, {200, 0, 0}, {0, 200, 0}), "zone3_entry");      // touches its edge
  EXPECT_EQ(checked(zones, {150, 50, 0}, {-50, 50, 1e6}), "zone3_entry");  // Z is not checked
  zones.suspend(3, true);
  EXPECT_EQ(checked(zones, {150, 50, 0}, {50, 50, 0}), "");
  setup.parameters.erase({"1001", "", "2"});
  EXPECT_EQ(checked(Zones(names, roles, no_ends(), setup), {150, 50, 0}, {50, 50, 0}), "zone3_reached_inside");
}

TEST(zones, end_positions) {
  Extents ends = no_ends();
  ends.least = {-100, -100, -100};
  ends.most = {100, 100, 100};
  const Zones before(names, roles, ends, bits("C")), after(names, roles, ends, {});
  EXPECT_EQ(checked(before, {}, {101, 0, 0}), "zone1_positive X");
  EXPECT_EQ(checked(before, {}, {0, 0, -101}), "zone1_negative Z");
  EXPECT_EQ(checked(before, {}, {100, -100, 100}), "");
  EXPECT_EQ(checked(before, {120, 0, 0}, {110, 0, 0}), "zone1_positive X");
  EXPECT_EQ(checked(after, {}, {101, 0, 0}), "zone1_reached_positive X");
  EXPECT_EQ(checked(after, {120, 0, 0}, {110, 0, 0}), "");
}

TEST(zones, arcs) {
  Extents ends = no_ends();
  ends.most[0] = 104;
  const Motion over = arc(arc_ccw, {95, 20, 0}, {95, 10, 0}, 0.5);  // up to X105
  const ToolPosition start{{95, 0, 0}, {95, 0, 0}};
  for (const char* const set : {"", "C"}) {
    const Status status = Zones(names, roles, ends, bits(set)).check(start, over);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().id, AlarmId::zone1_reached_positive);  // the end is within the limits: CBM lets it start
    EXPECT_EQ(status.error().args[1].number(), 104);
  }
  const Zones zones = zones_of(bits("C"), cube(-1, 1, false));
  const Motion ring = arc(arc_ccw, {5, 0, 0}, {0, 0, 0}, 1);
  EXPECT_TRUE(zones.check({{5, 0, 0}, {5, 0, 0}}, ring));
  const Motion through = arc(arc_ccw, {5, 0, 0}, {2.5, 0, 0}, 1);
  EXPECT_EQ(zones.check({{5, 0, 0}, {5, 0, 0}}, through).error().id, AlarmId::zone2_entry);
  const Motion past = arc(arc_ccw, {5, 0, 0}, {3, 0, 0}, 1);  // touches the face X1
  EXPECT_TRUE(zones.check({{5, 0, 0}, {5, 0, 0}}, past));
  Motion above = through;  // lies in a plane of the face
  above.to[2] = above.machine[2] = 1;
  EXPECT_TRUE(zones.check({{5, 0, 1}, {5, 0, 1}}, above));
}

TEST(zones, a_cheap_answer_where_none_is_in_force) {
  EXPECT_FALSE(Zones(names, roles, no_ends(), {}).in_force());
  EXPECT_TRUE(Zones(names, roles, no_ends(), {}).check({}, straight(feed, {1e9, 0, 0})));
}

/// Returns the first of `steps` samples that is inside the box; nullopt if none is.
std::optional<double> sampled(const ZoneBox& box, const MachinePath& path, int steps) {
  for (int i = 0; i <= steps; ++i)
    if (box.holds(path.at(double(i) / steps))) return double(i) / steps;
  return std::nullopt;
}

ZoneBox any_box() {
  ZoneBox box;
  box.axes = static_cast<AxisMask>(*rc::gen::inRange(1, 16));
  for (std::size_t a = 0; a < 4; ++a) {
    box.least[a] = a == 3 ? any_number(-100, 400) : any_number(-60, 60);
    box.most[a] = box.least[a] + any_number(0, a == 3 ? 100 : 30);
  }
  return box;
}

RC_GTEST_PROP(zones, a_path_meets_a_box_where_its_sampled_twin_does, ()) {
  const Moved moved = any_motion();
  const Curve curve(moved.roles, moved.from.work, moved.motion);
  const MachinePath path(moved.roles, moved.from, moved.motion, curve);
  const ZoneBox box = any_box();
  const auto part = first_meeting(box, path);
  const auto twin = sampled(box, path, 20'000);
  if (twin) RC_ASSERT(part && *part <= *twin + 1e-12);
  if (part) RC_ASSERT(box.grown(1e-6).holds(path.at(*part)));
}

RC_GTEST_PROP(zones, an_axis_passes_a_value_where_its_sampled_twin_does, ()) {
  const Moved moved = any_motion();
  const Curve curve(moved.roles, moved.from.work, moved.motion);
  const MachinePath path(moved.roles, moved.from, moved.motion, curve);
  const auto axis = static_cast<std::size_t>(*rc::gen::inRange(0, 4));
  const double value = path.start()[axis] + any_number(0, 40);
  const auto part = first_passing(path, axis, value, Side::above);
  bool passed = false;
  for (int i = 0; i <= 20'000; ++i) {
    const double at = i / 20'000.0;
    if (path.at(at)[axis] > value + 1e-9) {
      RC_ASSERT(part && *part <= at);
      passed = true;
      break;
    }
  }
  if (part && !passed) RC_ASSERT(std::abs(path.at(*part)[axis] - value) < 1e-3);  // the crossing is between two samples
  if (part) RC_ASSERT(path.at(*part)[axis] >= value - 1e-6);
}

}  // namespace
}  // namespace kadr::zones_test
