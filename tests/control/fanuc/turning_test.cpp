// control/fanuc/turning/turning: on random contours the rough passes leave the allowance, and the last pass follows it; G70.7 equals
// the contour written out; all planes behave alike. NCT 19.

#include "control/fanuc/turning/turning.h"

#include <algorithm>

#include "choices.h"
#include "control/run_program.h"

namespace kadr::turning_test {
namespace {

using namespace test;

/// The letters of the cutting axis (along which the passes run) and of the infeed axis, and of their increments.
struct Letters {
  const char* plane;
  const char* code;
  char cut, in, in_increment, cut_increment;
};
constexpr Letters kinds[] = {
    {"G18", "G71.7", 'Z', 'X', 'U', 'W'}, {"G19", "G72.7", 'Z', 'Y', 'V', 'W'}, {"G17", "G71.7", 'X', 'Y', 'V', 'U'}};

std::string number(int thousandths) {
  char text[24];
  std::snprintf(text, sizeof text, "%.3f", thousandths / 1000.0);
  return text;
}

/// A stepped shaft in thousandths: from the start (cut 0, in 0) down by `deep`, then along -cut and back towards 0.
struct Shaft {
  Letters letters = kinds[0];
  int deep = 1000, depth = 1000, back = 0, in_allowance = 0, cut_allowance = 0;
  struct Step {
    int along, up;
  };
  std::vector<Step> steps;

  std::string to(int cut, int in) const { return std::string(1, letters.cut) + number(cut) + letters.in + number(in) + "\n"; }
  std::string contour() const {
    std::string text = "N10 G0 " + std::string(1, letters.in) + number(-deep) + "\n";
    int cut = 0, in = -deep, block = 20;
    for (const Step& step : steps) {
      cut -= step.along;
      in = std::min(0, in + step.up);
      text += "N" + std::to_string(block) + " G1 " + to(cut, in);
      ++block;
    }
    return text + "N99 G1 " + std::string(1, letters.in) + "0\n";
  }
  std::string program() const {
    return std::string(letters.plane) + " G90 G94 F100\n" + letters.code + " " + letters.in_increment + number(depth) + " R" +
           number(back) + "\n" + letters.code + " P10 Q99 " + letters.in_increment + number(in_allowance) + " " + letters.cut_increment +
           number(cut_allowance) + " F200\n" + contour();
  }
  /// Returns the depth of the contour with allowances at a position: the infeed coordinate below which nothing may be cut.
  double floor_at(double cut) const {
    double from_cut = 0, from_in = -deep, least = 1e9;
    const double at = cut - cut_allowance;
    if (at > from_cut) return -deep + in_allowance;
    for (const Step& step : steps) {
      const double to_cut = from_cut - step.along, to_in = std::min(0.0, from_in + step.up);
      if (at <= from_cut && at >= to_cut)
        least = std::min(least, step.along == 0 ? from_in : from_in + (to_in - from_in) * (from_cut - at) / step.along);
      from_cut = to_cut, from_in = to_in;
    }
    return (least > 1e8 ? from_in : least) + in_allowance;
  }
};

Shaft random_shaft(Choices& choose) {
  Shaft s;
  s.letters = choose.of(kinds);
  s.deep = choose.between(1, 30) * 1000;
  s.depth = choose.between(1, 40) * 500;
  s.back = choose.between(0, 3) * 500;
  s.in_allowance = choose.between(0, 5) * 100;
  s.cut_allowance = choose.between(0, 5) * 100;
  for (std::size_t count = 1 + choose.below(6); count > 0; --count)
    s.steps.push_back({choose.between(0, 20) * 500, choose.between(0, 20) * 500});
  s.steps[0].along += 500;
  return s;
}

RC_GTEST_PROP(turning, roughs_above_the_contour_and_ends_on_it, ()) {
  Choices choose = choices(60);
  const Shaft s = random_shaft(choose);
  RC_TAG(std::string(s.letters.plane));
  const auto r = run("nct", s.program());
  if (!r.alarms.empty()) RC_FAIL(s.program() + r.first_alarm());
  const auto cut = static_cast<std::size_t>(s.letters.cut - 'X'), in = static_cast<std::size_t>(s.letters.in - 'X');
  const auto at = [](double v) { return v * 1000; };
  double here = 0;
  for (const Motion& m : r.motions()) {
    const double to = at(m.to[cut]), depth = at(m.to[in]);
    if (depth < std::min(s.floor_at(to), 0.0) - 1e-3) RC_FAIL(s.program() + "cuts to " + s.to(int(to), int(depth)));
    if (m.kind == MotionKind::rapid && depth < std::min(here, 0.0) - 1e-3 && to < -1e-3)
      RC_FAIL(s.program() + "goes in at rapid at " + s.to(int(to), int(depth)));
    here = depth;
  }
  const auto last = r.motions().back();
  RC_ASSERT(std::fabs(last.to[cut]) < 1e-9 && std::fabs(last.to[in]) < 1e-9);
  double deepest = 0;
  for (const Motion& m : r.motions()) deepest = std::min(deepest, at(m.to[in]));
  RC_ASSERT(std::fabs(deepest - (-s.deep + s.in_allowance)) < 1e-3);
}

std::vector<std::string> paths_of(const std::vector<Motion>& motions) {
  std::vector<std::string> all;
  for (const Motion& m : motions) {
    char text[100];
    std::snprintf(text, sizeof text, "%d %.6f %.6f %.6f F%g", int(m.kind), m.to[0] + 0.0, m.to[1] + 0.0, m.to[2] + 0.0, m.feed);
    all.emplace_back(text);
  }
  return all;
}

RC_GTEST_PROP(turning, finishes_as_if_the_contour_stood_there, ()) {
  Choices choose = choices(60);
  const Shaft s = random_shaft(choose);
  const std::string head = std::string(s.letters.plane) + " G90 G94 F100\n", back = "G0 " + s.to(0, 0);
  const auto cycle = run("nct", head + "G70.7 P10 Q99\nM30\n" + s.contour());
  RC_ASSERT(cycle.alarms.empty());
  auto written = paths_of(run("nct", head + s.contour() + back).motions());
  RC_ASSERT(paths_of(cycle.motions()) == written);
}

TEST(turning, an_alarm_takes_the_first_line_back) {
  const auto r = run("nct", "G18 F100\nG71.7 U5 R-1\nG71.7 P10 Q20\nN10 G0 X-5\nN20 G1 Z-5\n", {}, OnAlarm::go_on);
  ASSERT_EQ(r.alarms.size(), 2U);
  EXPECT_EQ(name_of(r.alarms[1].alarm.id), "word_missing");  // the depth of cut in the faulty line is not kept
}

TEST(turning, the_contour_is_carried_out_where_the_cycle_fails) {  // checking continues with the next block
  const auto r = run("nct", "G18 F100\nG71.7 P10 Q20\nN10 G0 X-5\nN20 G1 Z-5\n", {}, OnAlarm::go_on);
  EXPECT_EQ(r.alarms.size(), 1U);
  EXPECT_EQ(r.motions().size(), 2U);
}

}  // namespace
}  // namespace kadr::turning_test
