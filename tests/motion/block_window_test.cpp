// motion/look_ahead/block_window: times within a small part of those of a second implementation of Grbl's planner, on programs of many
// kinds; and the same times after a snapshot.

#include "motion/look_ahead/block_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "actions.h"
#include "motion/look_ahead/look_ahead.h"
#include "motion/planner_twin.h"
#include "motion/time/steps.h"

namespace kadr::block_window_test {
namespace {

constexpr double near = 0.002;  // greatest relative difference of two times; the issue asks for 0.03

/// A path for both: lines and arcs in the plane XY. `feed`: mm/min, 0 is a rapid.
struct Piece {
  Vec3 to;
  double feed = 0;
  std::optional<Vec3> centre{};
  double turns = 0;  // signed: positive is counter-clockwise
};

struct Machine {
  Vec3 rate{3000, 3000, 1000};       // mm/min
  Vec3 acceleration{200, 200, 100};  // mm/s²
  double junction = 0.01;
};

double by_twin(const std::vector<Piece>& path, const Machine& machine) {
  test::TwinSettings settings;
  settings.rate = {machine.rate.x / 60, machine.rate.y / 60, machine.rate.z / 60};
  settings.acceleration = {machine.acceleration.x, machine.acceleration.y, machine.acceleration.z};
  settings.junction_deviation = machine.junction;
  test::PlannerTwin twin(settings);
  for (const Piece& piece : path) {
    const std::array<double, 3> to = {piece.to.x, piece.to.y, piece.to.z};
    if (piece.centre) twin.arc(to, {piece.centre->x, piece.centre->y}, 2 * M_PI * piece.turns, piece.feed / 60);
    else twin.line(to, piece.feed / 60);
  }
  return twin.finish();
}

std::vector<Action> actions_of(const std::vector<Piece>& path) {
  std::vector<Action> actions;
  for (const Piece& piece : path) {
    Motion motion = piece.centre ? test::arc(piece.turns > 0 ? MotionKind::arc_ccw : MotionKind::arc_cw, piece.to, *piece.centre,
                                             std::fabs(piece.turns))
                                 : test::straight(piece.feed > 0 ? MotionKind::feed : MotionKind::rapid, piece.to);
    motion.feed = piece.feed;
    actions.push_back(test::action(motion));
  }
  return actions;
}

/// Returns the time of all motions. `half`: the state is stored and restored in a new object after this many actions.
double by_kadr(const std::vector<Piece>& path, const Machine& machine, std::size_t half = 0) {
  const std::vector<std::string> names = {"X", "Y", "Z"};
  const AxisRoles roles = AxisRoles::of(names, 0);
  Setup setup;
  const double rates_[] = {machine.rate.x, machine.rate.y, machine.rate.z};
  const double accelerations[] = {machine.acceleration.x, machine.acceleration.y, machine.acceleration.z};
  for (std::size_t a = 0; a < 3; ++a) {
    setup.machine[names[a]].rapid = rates_[a];
    setup.machine[names[a]].acceleration = accelerations[a];
  }
  SpeedRules rules = speed_rules(setup, names);
  rules.blocks = BlockPlanner{15, machine.junction, 0.002};
  const Rates rates = rates_of(MachineProfile{}, setup, names);
  TimeEstimate estimate(roles, rates);
  double sum = 0;
  const auto sink = [&](const Step& step, double longer) {
    if (step.motion() == nullptr) return;
    sum += step.time.seconds;
    estimate.lengthen(*step.motion(), longer);
  };
  auto look_ahead = std::make_unique<LookAhead>(roles, rules, rates.rapid, sink);
  Steps steps(roles, {}, &estimate);
  std::size_t count = 0;
  for (const Action& action : actions_of(path)) {
    steps.give(action, [&](const Step& step) { look_ahead->consume(step); });
    if (++count != half) continue;
    const LookAhead::Memory memory = look_ahead->memory();
    look_ahead = std::make_unique<LookAhead>(roles, rules, rates.rapid, sink);
    look_ahead->resume_from(memory);
  }
  look_ahead->finish();
  return sum;
}

std::vector<Piece> curve(int count, double feed, const std::function<Vec3(double)>& at) {
  std::vector<Piece> path;
  for (int i = 1; i <= count; ++i) path.push_back({at(double(i) / count), feed});
  return path;
}

/// Ten programs of different kinds.
std::vector<std::pair<std::string, std::vector<Piece>>> programs() {
  std::vector<std::pair<std::string, std::vector<Piece>>> all;
  all.emplace_back("wave of short lines", curve(1500, 3000, [](double t) { return Vec3{150 * t, 3 * std::sin(40 * t), 0}; }));
  all.emplace_back("surface", curve(2000, 2000, [](double t) { return Vec3{50 * std::sin(300 * t), 60 * t, 4 * std::cos(90 * t)}; }));
  all.emplace_back("line", curve(100, 1200, [](double t) { return Vec3{80 * t, 40 * t, 0}; }));
  all.emplace_back("star", curve(60, 2500, [](double t) {
                     const double angle = 60 * t * M_PI * 0.8;
                     return Vec3{30 * std::cos(angle), 30 * std::sin(angle), 0};
                   }));
  std::vector<Piece> squares, pocket, arcs, drilling;
  for (int i = 1; i < 20; ++i)
    for (const Vec3 corner : {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 0}}) squares.push_back({double(i) * corner, 1500});
  all.emplace_back("squares", squares);
  for (int i = 0; i < 12; ++i) {
    pocket.push_back({{0, i * 2.0, 0}});
    pocket.push_back({{0, i * 2.0, -2}, 300});
    pocket.push_back({{60, i * 2.0, -2}, 1800});
    pocket.push_back({{60, i * 2.0, 2}});
  }
  all.emplace_back("passes with rapids", pocket);
  for (int i = 0; i < 15; ++i) {
    const double x = i * 10;
    arcs.push_back({{x + 10, 0, 0}, 2000, Vec3{x + 5, 0, 0}, i % 2 == 0 ? 0.5 : -0.5});
  }
  all.emplace_back("half circles", arcs);
  all.emplace_back("circle", std::vector<Piece>{{{40, 0, 0}, 1000}, {{40, 0, -3}, 2800, Vec3{20, 0, 0}, 1}, {{0, 0, 0}}});
  for (int i = 0; i < 30; ++i) {
    drilling.push_back({{i % 6 * 15.0, i / 6 * 15.0, 2}});
    drilling.push_back({{i % 6 * 15.0, i / 6 * 15.0, -5}, 200});
    drilling.push_back({{i % 6 * 15.0, i / 6 * 15.0, 2}});
  }
  all.emplace_back("drilling", drilling);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1, 1);
  std::vector<Piece> scattered;
  Vec3 at{};
  for (int i = 0; i < 800; ++i) {
    at = at + (i % 7 == 0 ? 20.0 : 0.5) * Vec3{place(random), place(random), place(random) / 4};
    scattered.push_back({at, i % 11 == 0 ? 0 : 1000 + 900 * place(random)});
  }
  all.emplace_back("scattered", scattered);
  return all;
}

TEST(BlockWindow, TakesTheTimeOfGrblsPlanner) {
  for (const Machine& machine :
       {Machine{}, Machine{{6000, 5000, 2000}, {500, 300, 150}, 0.02}, Machine{{500, 500, 500}, {10, 10, 10}, 0.01}})
    for (const auto& [name, path] : programs()) {
      const double twin = by_twin(path, machine), kadr = by_kadr(path, machine);
      EXPECT_NEAR(kadr / twin, 1, near) << name << ": Kadr " << kadr << " s, twin " << twin << " s";
    }
}

TEST(BlockWindow, TimesDoNotDependOnASnapshot) {
  for (const auto& [name, path] : programs())
    for (const std::size_t half : {std::size_t{1}, path.size() / 2, path.size()})
      EXPECT_EQ(by_kadr(path, {}), by_kadr(path, {}, half)) << name << ' ' << half;
}

TEST(BlockWindow, IsSlowInShortLinesAndFastInLongOnes) {
  const auto line = [](int count) { return curve(count, 3000, [](double t) { return Vec3{100 * t, 0, 0}; }); };
  EXPECT_NEAR(by_kadr(line(10), {}), 100 / 50.0 + 50 / 200.0, 1e-9);
  // 14 blocks of 0.1 mm are ahead of the oldest: √(2 · 200 · 1.4 mm) = 23.7 mm/s
  EXPECT_NEAR(by_kadr(line(1000), {}), 100 / 24.2, 0.3);
}

}  // namespace
}  // namespace kadr::block_window_test
