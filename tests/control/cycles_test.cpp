// control/cycles: G73 and G81–G89 give the motions of their long form written out. Mach3 10.7.22–10.7.24, spec mach3 4.

#include <algorithm>

#include "choices.h"
#include "control/run_program.h"
#include "control/state/control_state.h"

namespace kadr::cycles_test {
namespace {

using namespace test;

/// A row of holes, in thousandths of a millimetre so that sums are exact.
struct Drilling {
  std::string code;
  Plane plane = Plane::xy;
  bool absolute = true, initial = true;
  int start = 0, level = 0, depth = 0, peck = 0, repeats = 1;  // depth below the level
  double dwell = 0;
  struct Hole {
    int first, second;
  };
  std::vector<Hole> holes;

  char first() const { return plane == Plane::xy ? 'X' : plane == Plane::zx ? 'X' : 'Y'; }
  char second() const { return plane == Plane::xy ? 'Y' : 'Z'; }
  char drill() const { return plane == Plane::xy ? 'Z' : plane == Plane::zx ? 'Y' : 'X'; }
  std::string preparation() const {
    return std::string("G21 G90 F100\n") +
           (plane == Plane::xy   ? "G17"
            : plane == Plane::zx ? "G18"
                                 : "G19") +
           " G0 " + drill() + number(start) + "\n";
  }
  static std::string number(int thousandths) {
    char text[24];
    std::snprintf(text, sizeof text, "%.3f", thousandths / 1000.0);
    return text;
  }
};

Drilling random_drilling(Choices& choose) {
  static constexpr const char* codes[] = {"G81", "G82", "G83", "G73", "G85", "G89"};
  static constexpr Plane planes[] = {Plane::xy, Plane::zx, Plane::yz};
  Drilling d;
  d.code = choose.of(codes);
  d.plane = choose.of(planes);
  d.absolute = choose.below(2) == 0;
  d.initial = choose.below(2) == 0;
  d.start = choose.between(-20, 20) * 1000;
  d.level = choose.between(-10, 10) * 1000;
  d.depth = choose.between(1, 20'000);
  d.peck = choose.between(100, 9000);
  d.dwell = choose.between(0, 4) / 2.0;
  d.repeats = choose.one_in(3) ? choose.between(2, 4) : 1;
  for (std::size_t count = 1 + choose.below(4); count > 0; --count)
    d.holes.push_back({choose.between(-50, 50) * 100, choose.between(-50, 50) * 100});
  return d;
}

bool pecks(const Drilling& d) { return d.code == "G83" || d.code == "G73"; }
bool dwells(const Drilling& d) { return d.code == "G82" || d.code == "G89"; }

/// Writes the row as a canned cycle: all words in the first block, then the hole positions only. With G91, R counts from the current
/// position of the tool. It is written in each block, because it would otherwise be added again.
std::string short_form(const Drilling& d) {
  std::string text = d.preparation() + (d.absolute ? "G90 " : "G91 ") + (d.initial ? "G98 " : "G99 ") + d.code;
  const int level = d.absolute ? d.level : d.level - d.start;
  const int bottom = d.absolute ? d.level - d.depth : -d.depth;
  text += std::string(" ") + d.drill() + Drilling::number(bottom) + " R" + Drilling::number(level);
  if (pecks(d)) text += " Q" + Drilling::number(d.peck);
  if (dwells(d)) text += " P" + std::to_string(d.dwell);
  const int clear = d.initial ? std::max(d.start, d.level) : d.level;
  for (std::size_t i = 0; i < d.holes.size(); ++i) {
    if (i != 0 && !d.absolute) text += std::string("R") + Drilling::number(d.level - clear);
    text += std::string(" ") + d.first() + Drilling::number(d.holes[i].first) + d.second() + Drilling::number(d.holes[i].second);
    if (d.repeats != 1) text += " L" + std::to_string(d.repeats);
    text += "\n";
  }
  return text;
}

std::string one_hole(const Drilling& d, int clear) {
  const std::string down = std::string("G1 ") + d.drill(), rapid = std::string("G0 ") + d.drill();
  const int bottom = d.level - d.depth;
  std::string text;
  if (pecks(d))
    for (int at = d.level - d.peck; at > bottom; at -= d.peck) {
      text += down + Drilling::number(at) + "\n";
      const Behaviour& b = control("mach3").behaviour;  // retract distances: settings of the machine, INFERRED in controls/mach3.toml
      const int back = static_cast<int>(std::lround(b.return_chip_break * 1000)),
                near = static_cast<int>(std::lround(b.return_near * 1000));
      text += rapid + Drilling::number(d.code == "G83" ? d.level : std::min(d.level, at + back)) + "\n";
      text += rapid + Drilling::number(std::min(d.level, at + near)) + "\n";
    }
  text += down + Drilling::number(bottom) + "\n";
  if (dwells(d) && d.dwell > 0) text += "G4 P" + std::to_string(d.dwell) + "\n";
  return text + (d.code == "G85" || d.code == "G89" ? down : rapid) + Drilling::number(clear) + "\n";
}

/// Writes the same row motion by motion, in absolute coordinates.
std::string long_form(const Drilling& d) {
  std::string text = d.preparation();
  const int clear = d.initial ? std::max(d.start, d.level) : d.level;
  if (d.start < d.level) text += std::string("G0 ") + d.drill() + Drilling::number(d.level) + "\n";
  int first = 0, second = 0;
  for (const Drilling::Hole& hole : d.holes)
    for (int i = 0; i < d.repeats; ++i) {
      first = d.absolute ? hole.first : first + hole.first;
      second = d.absolute ? hole.second : second + hole.second;
      text += std::string("G0 ") + d.first() + Drilling::number(first) + d.second() + Drilling::number(second) + "\n";
      text += std::string("G0 ") + d.drill() + Drilling::number(d.level) + "\n" + one_hole(d, clear);
    }
  return text;
}

/// Returns the motions that change the position, and the dwells, rounded to a nanometre because increments are summed.
std::vector<std::string> steps_of(const std::string& program) {
  const auto r = run("mach3", program);
  std::vector<std::string> steps;
  Axes at{};
  for (const Action& a : r.actions) {
    char text[120];
    if (const auto* m = std::get_if<Motion>(&a.what)) {
      const double travel = length(Vec3{m->to[0] - at[0], m->to[1] - at[1], m->to[2] - at[2]});
      if (travel < 1e-9) continue;
      at = m->to;
      std::snprintf(text, sizeof text, "%d %.6f %.6f %.6f F%g", int(m->kind), at[0] + 0.0, at[1] + 0.0, at[2] + 0.0, m->feed);
      steps.emplace_back(text);
    }
    if (const auto* d = std::get_if<Dwell>(&a.what)) steps.push_back("dwell " + std::to_string(d->seconds));
  }
  for (std::string& step : steps)
    for (std::size_t zero; (zero = step.find("-0.000000")) != std::string::npos;) step.erase(zero, 1);
  for (const AlarmReport& alarm : r.alarms) steps.push_back(std::string(name_of(alarm.alarm.id)));
  return steps;
}

RC_GTEST_PROP(cycles, give_the_motions_of_the_long_form, ()) {
  Choices choose = choices(60);
  const Drilling d = random_drilling(choose);
  RC_TAG(d.code);
  const auto cycle = steps_of(short_form(d));
  const auto written = steps_of(long_form(d));
  if (cycle == written) return;
  std::string text = short_form(d) + "gave\n";
  for (const std::string& step : cycle) text += "  " + step + "\n";
  text += "not\n";
  for (const std::string& step : written) text += "  " + step + "\n";
  RC_FAIL(text);
}

std::vector<std::size_t> kinds_of(const test::Run& r) {
  std::vector<std::size_t> kinds;
  for (const Action& a : r.actions) kinds.push_back(a.what.index());
  return kinds;
}

TEST(cycles, come_before_the_stop_of_their_block) {  // order of execution, spec mach3 2: motion, then M0
  const auto r = run("mach3", "G21 F100\nG81 X1 Y1 Z-1 R2 M0\n");
  ASSERT_EQ(r.first_alarm(), "");
  EXPECT_TRUE(std::holds_alternative<Stop>(r.actions.back().what)) << testing::PrintToString(kinds_of(r));
}

TEST(cycles, come_before_the_end_of_their_block) {
  const auto r = run("mach3", "G21 F100\nG55 G0 X0 Y0 Z0\nG81 X1 Y1 Z-1 R2 M30\n", [] {
    kadr::Setup s;
    s.work_offsets["G55"] = {{"X", 100}};
    return s;
  }());
  ASSERT_EQ(r.first_alarm(), "");
  for (const Motion& m : r.motions())
    if (m.kind == MotionKind::feed) {
      EXPECT_NEAR(m.machine[0], 101, 1e-9);
    }
  EXPECT_EQ(r.motions().size(), 6u);  // to the start, up to R, over the hole, down, up
}

TEST(cycles, that_turn_the_spindle_stop_reverse_and_restore_it) {
  const auto turns = [](const std::string& program) {
    std::string text;
    for (const Action& a : run("mach3", "G21 F100 S500\n" + program).actions)
      if (const auto* s = std::get_if<Spindle>(&a.what))
        text += s->dir == SpindleDir::cw ? "cw " : s->dir == SpindleDir::ccw ? "ccw " : s->dir == SpindleDir::stop ? "stop " : "orient ";
    return text;
  };
  EXPECT_EQ(turns("M3\nG84 X1 Z-1 R1\n"), "cw stop ccw stop cw ");
  EXPECT_EQ(turns("M4\nG86 X1 Z-1 R1 P0\n"), "ccw stop ccw ");
  EXPECT_EQ(run("mach3", "F100\nG86 X1 Z-1 R1 P0\n").first_alarm(), "spindle_not_turning");
  EXPECT_EQ(run("mach3", "F100 S500 M4\nG84 X1 Z-1 R1\n").first_alarm(), "spindle_direction");
}

}  // namespace
}  // namespace kadr::cycles_test
