// control/fanuc/drilling/drilling: a canned cycle equals its long form written out, in every plane and unit; L, G98, G99. NCT 18.

#include "control/fanuc/drilling/drilling.h"

#include <algorithm>

#include "choices.h"
#include "control/run_program.h"

namespace kadr::drilling_test {
namespace {

using namespace test;
using Machine = kadr::Setup;  // in a test, Setup would mean GoogleTest's Setup

/// The axes of a plane in the order of the manual's table, and the letters of the shift.
struct Letters {
  const char* code;
  char first, second, drill, shift_first, shift_second;
};
constexpr Letters planes[] = {{"G17", 'X', 'Y', 'Z', 'I', 'J'}, {"G18", 'Z', 'X', 'Y', 'K', 'I'}, {"G19", 'Y', 'Z', 'X', 'J', 'K'}};

/// A row of holes, in thousandths of a millimetre so that sums are exact.
struct Holes {
  std::string code;
  Letters plane = planes[0];
  bool absolute = true, initial = true, inch = false;
  int start = 0, level = 0, depth = 1, peck = 1, back = 0, repeats = 1, dwell = 0, shift = 0;  // dwell in tenths of a second
  struct Hole {
    int first, second;
  };
  std::vector<Hole> holes;

  /// Returns a length as the program writes it.
  std::string length(int thousandths) const {
    char text[40];
    if (inch) std::snprintf(text, sizeof text, "%.12f", thousandths / 25400.0);
    else std::snprintf(text, sizeof text, "%.3f", thousandths / 1000.0);
    return text;
  }
  std::string seconds() const { return std::to_string(dwell / 10) + "." + std::to_string(dwell % 10); }
  int bottom() const { return level - depth; }
  int clear() const { return initial ? start : level; }
};

Holes random_holes(Choices& choose) {
  static constexpr const char* codes[] = {"G81", "G82", "G83", "G73", "G85", "G89", "G74", "G84", "G86", "G88", "G76"};
  Holes h;
  h.code = choose.of(codes);
  h.plane = choose.of(planes);
  h.absolute = choose.below(2) == 0;
  h.initial = choose.below(2) == 0;
  h.level = choose.between(-10, 10) * 1000;
  h.start = h.level + choose.between(0, 20) * 1000;
  h.depth = choose.between(1, 20'000);
  h.peck = choose.between(100, 9000);
  h.back = choose.between(0, 900);
  h.dwell = choose.between(0, 30);
  h.shift = choose.between(-20, 20) * 10;
  h.repeats = choose.one_in(3) ? choose.between(2, 4) : 1;
  for (std::size_t count = 1 + choose.below(4); count > 0; --count)
    h.holes.push_back({choose.between(-50, 50) * 100, choose.between(-50, 50) * 100});
  return h;
}

bool is_any(const Holes& h, std::initializer_list<const char*> codes) {
  return std::find(codes.begin(), codes.end(), h.code) != codes.end();
}
bool pecks(const Holes& h) { return is_any(h, {"G83", "G73"}); }
bool dwells(const Holes& h) { return is_any(h, {"G82", "G89", "G74", "G84", "G88", "G76"}); }

std::string preparation(const Holes& h) {
  const std::string feed = h.inch ? "F10" : "F254";
  return std::string(h.inch ? "G20" : "G21") + " G90 G94 S500 M3 " + feed + " " + h.plane.code + "\nG0 " + h.plane.drill +
         h.length(h.start) + "\n";
}

/// All words in the first block, then the positions only: the data are modal, also with G91.
std::string short_form(const Holes& h) {
  std::string text = preparation(h) + (h.absolute ? "G90 " : "G91 ") + (h.initial ? "G98 " : "G99 ") + h.code + " ";
  text += h.plane.drill + h.length(h.absolute ? h.bottom() : -h.depth) + " R" + h.length(h.absolute ? h.level : h.level - h.start);
  if (pecks(h)) text += " Q" + h.length(h.peck) + " E" + h.length(h.back);
  if (dwells(h)) text += " P" + h.seconds();
  if (h.code == "G76") text += std::string(" ") + h.plane.shift_first + h.length(h.shift) + " " + h.plane.shift_second + h.length(-h.shift);
  for (const Holes::Hole& hole : h.holes) {
    text += std::string(" ") + h.plane.first + h.length(hole.first) + " " + h.plane.second + h.length(hole.second);
    if (h.repeats != 1) text += " L" + std::to_string(h.repeats);
    text += "\n";
  }
  return text;
}

class LongForm {
 public:
  explicit LongForm(const Holes& h) : h_(h) {}

  std::string text() {
    text_ = preparation(h_);
    for (const Holes::Hole& hole : h_.holes)
      for (int i = 0; i < h_.repeats; ++i) {
        first_ = h_.absolute ? hole.first : first_ + hole.first;
        second_ = h_.absolute ? hole.second : second_ + hole.second;
        over(first_, second_);
        rapid(h_.level);
        hole_of_code();
      }
    return text_;
  }

 private:
  void line(const std::string& words) { text_ += words + "\n"; }
  void rapid(int level) { line(std::string("G0 ") + h_.plane.drill + h_.length(level)); }
  void feed(int level) { line(std::string("G1 ") + h_.plane.drill + h_.length(level)); }
  void over(int first, int second) {
    line(std::string("G0 ") + h_.plane.first + h_.length(first) + " " + h_.plane.second + h_.length(second));
  }
  void pause() {
    if (h_.dwell > 0) line("G4 P" + h_.seconds());
  }

  void hole_of_code() {
    if (pecks(h_))
      for (int at = h_.level - h_.peck; at > h_.bottom(); at -= h_.peck) {
        feed(at);
        if (h_.code == "G83") rapid(h_.level);
        rapid(std::min(h_.level, at + h_.back));
      }
    feed(h_.bottom());
    if (dwells(h_)) pause();
    out();
  }

  void out() {
    const bool tap = is_any(h_, {"G74", "G84"});
    if (tap) line(h_.code == "G74" ? "M3" : "M4");
    if (is_any(h_, {"G86", "G88"})) line("M5");
    if (h_.code == "G88") line("M0");
    if (h_.code == "G76") {
      line("M19");
      over(first_ + h_.shift, second_ - h_.shift);
    }
    if (tap || is_any(h_, {"G85", "G89"})) feed(h_.level);
    if (tap) line(h_.code == "G74" ? "M4" : "M3");
    rapid(h_.clear());
    if (h_.code == "G76") over(first_, second_);
    if (is_any(h_, {"G86", "G88", "G76"})) line("M3");
  }

  const Holes& h_;
  std::string text_;
  int first_ = 0, second_ = 0;
};

Machine machine() {
  Machine setup;
  setup.parameters[{"0607", "1", "1"}] = 1.0;
  return setup;
}

/// Returns the steps, with the axes in the order first, second, drilling axis: motions that change the position, dwells, spindle,
/// stops; rounded to a nanometre.
std::vector<std::string> steps_of(const std::string& program, const Letters& plane = planes[0]) {
  const auto index = [](char letter) { return static_cast<std::size_t>(letter - 'X'); };
  const std::size_t order[] = {index(plane.first), index(plane.second), index(plane.drill)};
  const auto r = run("nct", program, machine());
  std::vector<std::string> steps;
  Axes at{};
  for (const Action& a : r.actions) {
    char text[120];
    if (const auto* m = std::get_if<Motion>(&a.what)) {
      if (length(Vec3{m->to[0] - at[0], m->to[1] - at[1], m->to[2] - at[2]}) < 1e-9) continue;
      at = m->to;
      const double feed = m->kind == MotionKind::rapid ? 0 : m->feed;
      std::snprintf(text, sizeof text, "%d %.6f %.6f %.6f F%.6f", int(m->kind), at[order[0]], at[order[1]], at[order[2]], feed);
      steps.emplace_back(text);
    }
    if (const auto* d = std::get_if<Dwell>(&a.what)) steps.push_back("dwell " + std::to_string(d->seconds));
    if (const auto* s = std::get_if<Spindle>(&a.what)) steps.push_back("spindle " + std::to_string(int(s->dir)));
    if (std::holds_alternative<Stop>(a.what)) steps.emplace_back("stop");
  }
  for (std::string& step : steps)
    for (std::size_t zero; (zero = step.find("-0.000000")) != std::string::npos;) step.erase(zero, 1);
  if (!r.alarms.empty()) RC_FAIL(program + "gave " + r.first_alarm());
  return steps;
}

void same(const std::string& one, const std::vector<std::string>& gave, const std::vector<std::string>& wanted) {
  if (gave == wanted) return;
  std::string text = one + "gave\n";
  for (const std::string& step : gave) text += "  " + step + "\n";
  text += "not\n";
  for (const std::string& step : wanted) text += "  " + step + "\n";
  RC_FAIL(text);
}

RC_GTEST_PROP(drilling, gives_the_actions_of_the_long_form, ()) {
  Choices choose = choices(60);
  const Holes h = random_holes(choose);
  RC_TAG(h.code);
  same(short_form(h), steps_of(short_form(h)), steps_of(LongForm(h).text()));
}

RC_GTEST_PROP(drilling, is_the_same_in_every_plane, ()) {
  Choices choose = choices(60);
  Holes h = random_holes(choose);
  h.plane = planes[0];
  const auto in_xy = steps_of(short_form(h));
  for (const Letters& plane : planes) {
    h.plane = plane;
    same(short_form(h), steps_of(short_form(h), plane), in_xy);
  }
}

RC_GTEST_PROP(drilling, is_the_same_in_inches, ()) {
  Choices choose = choices(60);
  Holes h = random_holes(choose);
  const auto in_mm = steps_of(short_form(h));
  h.inch = true;
  same(short_form(h), steps_of(short_form(h)), in_mm);
}

RC_GTEST_PROP(drilling, repeats_increments_as_single_holes, ()) {
  Choices choose = choices(60);
  Holes h = random_holes(choose);
  h.absolute = false;
  h.holes.resize(1);
  h.repeats = choose.between(1, 6);
  const auto at_once = steps_of(short_form(h));
  const Holes::Hole hole = h.holes[0];
  h.holes.assign(static_cast<std::size_t>(h.repeats), hole);
  h.repeats = 1;
  same(short_form(h), steps_of(short_form(h)), at_once);
}

RC_GTEST_PROP(drilling, repeats_polar_angles_as_single_holes, ()) {
  Choices choose = choices(20);
  const int count = choose.between(1, 8), angle = choose.between(-90, 90), radius = choose.between(1, 50);
  const std::string polar = "G16 G0 X" + std::to_string(radius) + " Y0\nG81 Z-8 R2 F100 YI" + std::to_string(angle);
  std::string apart = polar + "\n";
  for (int i = 1; i < count; ++i) apart += "YI" + std::to_string(angle) + "\n";
  same(polar, steps_of(polar + " L" + std::to_string(count)), steps_of(apart));
}

RC_GTEST_PROP(drilling, cuts_the_same_with_g98_and_g99, ()) {
  Choices choose = choices(60);
  Holes h = random_holes(choose);
  const auto cuts_and_end = [&](bool initial) {
    h.initial = initial;
    std::pair<std::vector<std::string>, double> result;
    const auto r = run("nct", short_form(h), machine());
    for (const Motion& m : r.motions())
      if (m.kind != MotionKind::rapid) result.first.push_back(std::to_string(m.to[0]) + std::to_string(m.to[1]) + std::to_string(m.to[2]));
    result.second = r.ending.position[static_cast<std::size_t>(h.plane.drill - 'X')];
    return result;
  };
  const auto to_initial = cuts_and_end(true), to_level = cuts_and_end(false);
  RC_ASSERT(to_initial.first == to_level.first);
  RC_ASSERT(std::fabs(to_initial.second - h.start / 1000.0) < 1e-9);
  RC_ASSERT(std::fabs(to_level.second - h.level / 1000.0) < 1e-9);
}

TEST(drilling, runs_in_batches) {  // constant memory: a batch is emitted while the cycle continues
  const auto r = run("nct", "G91 G81 X0.001 Z-1 R-1 F100 L20000\n");
  EXPECT_EQ(r.first_alarm(), "");
  EXPECT_NEAR(r.ending.position[0], 20, 1e-6);
  EXPECT_EQ(r.motions().size(), 4U * 20'000);
}

TEST(drilling, an_alarm_takes_the_data_back) {
  const auto r = run("nct", "G81 X1 Z-1 R1 F100\nX2 Z-5 R3 Q-1\nX3\n", {}, OnAlarm::go_on);
  ASSERT_EQ(r.alarms.size(), 1U);
  std::vector<double> bottoms;
  for (const Motion& m : r.motions())
    if (m.kind == MotionKind::feed) bottoms.push_back(m.to[2]);
  EXPECT_EQ(bottoms, (std::vector<double>{-1, -1}));
}

TEST(drilling, an_alarm_behind_operation_1_takes_it_back) {  // the dwell in revolutions is checked after S and M5
  const auto r = run("nct", "S500 M3 G95\nG82 X5 Z-1 R1 P10 F0.1 M5\n");
  EXPECT_EQ(r.first_alarm(), "spindle_not_turning");
  EXPECT_TRUE(r.motions().empty());
}

}  // namespace
}  // namespace kadr::drilling_test
