// session/cutting/machine_watch, axes_path, dog_leg: steps written by hand, and the bodies of a machine that collide during them.

#include "session/cutting/machine_watch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "session/cutting/axes_path.h"

namespace kadr::machine_watch_test {
namespace {

const std::vector<std::string> axis_names = {"X", "Y", "Z"};
const AxisRoles roles = AxisRoles::of(axis_names, 0);
const Axes origin = {-300, -200, -390};
constexpr double length_of_tool = 80;

BodyShape box(Vec3 least, Vec3 most) { return {BodyShape::Form::box, least, most, {}, 0, 0, 0, {}}; }

/// X, Y, Z move a head of 160 x 160 mm above the gauge point.
MachineProfile gantry() {
  MachineProfile machine;
  machine.bodies = {{"head", "Z", box({-80, -80, 0}, {80, 80, 300})}, {"table", "", box({-650, -450, -480}, {50, 50, -420})}};
  return machine;
}

Axes in_machine(const Axes& work) {
  Axes machine = work;
  for (std::size_t i = 0; i < 3; ++i) machine[i] += origin[i];
  machine[2] += length_of_tool;
  return machine;
}

/// Sends steps one after the other, 1 s each.
class Steps {
 public:
  explicit Steps(MachineWatch& watch) : watch_(watch) {
    Action frame;
    FrameChange change{};
    change.placement.origin = origin;
    change.placement.length[2] = length_of_tool;
    frame.what = change;
    pass(frame);
  }
  void to(MotionKind kind, const Axes& work, std::uint32_t line) {
    Action action;
    action.origin.line = line;
    Motion motion;
    motion.kind = kind;
    motion.to = work;
    motion.machine = in_machine(work);
    motion.named = 7;
    action.what = motion;
    pass(action);
    stand_.take(action);
  }
  void pass(const Action& action) {
    const Step step(roles, action, stand_, now_, MotionTime{0, 1});
    watch_.take(step, {(step).begins, (step).time.seconds}, found, notes);
    if (step.motion() != nullptr) now_ += 1;
  }

  std::vector<CutFinding> found;
  std::vector<std::string> notes;

 private:
  MachineWatch& watch_;
  ToolPosition stand_;
  double now_ = 0;
};

std::unique_ptr<MachineWatch> watch_with(const BodyShape& clamp, const std::optional<Axes>& apart = {}) {
  CutJob job;
  job.starts_known = false;
  job.lengths[1] = length_of_tool;
  job.tool = 1;
  job.apart = apart;
  auto watch =
      MachineWatch::of(gantry(), axis_names, roles, job, {{"clamp", clamp}},
                       [](const std::string&) -> tl::expected<Mesh, std::string> { return tl::unexpected(std::string("no files")); });
  EXPECT_TRUE(watch) << watch.error();
  return watch ? std::move(*watch) : nullptr;
}

TEST(machine_watch, the_head_meets_a_clamp) {
  const auto watch = watch_with(box({60, -20, -30}, {100, 20, 100}));
  Steps steps(*watch);
  steps.to(MotionKind::rapid, {-150, 0, 150}, 1);
  steps.to(MotionKind::rapid, {-150, 0, 5}, 2);  // kept until the next motion: the clamp uses the work offset of the first feed motion
  steps.to(MotionKind::feed, {50, 0, 5}, 3);
  steps.to(MotionKind::feed, {55, 0, 5}, 4);
  ASSERT_EQ(steps.found.size(), 1U);
  const CutFinding& finding = steps.found.front();
  EXPECT_EQ(finding.id, AlarmId::machine);
  EXPECT_EQ(finding.origin.line, 3U);
  EXPECT_EQ(finding.tool, 1U);
  EXPECT_EQ(finding.bodies, (std::array<std::string, 2>{"head", "clamp"}));
  EXPECT_NEAR(finding.at.x, 60, 0.01);                       // in work coordinates
  EXPECT_NEAR(finding.at_time, 2 + 130. / 200, 0.01 / 200);  // 130 of 200 mm: the head's side is 80 mm from the axis
  EXPECT_NEAR(finding.depth, 15, 0.1);                       // the clamp reaches 15 mm above the spindle nose
}

TEST(machine_watch, a_rapid_of_axes_that_go_apart) {
  const BodyShape next_to_path =
      box({-55, 90, -30}, {-45, 120, 100});  // with separate axes the head reaches it before X has moved the head past
  for (const bool apart : {false, true}) {
    const auto watch = watch_with(next_to_path, apart ? std::optional<Axes>({100, 100, 100}) : std::nullopt);
    Steps steps(*watch);
    steps.to(MotionKind::rapid, {-100, -100, 5}, 1);
    steps.to(MotionKind::feed, {-100, -100, 4}, 2);
    steps.to(MotionKind::rapid, {60, 20, 4}, 3);  // with separate axes: through 20, 20
    EXPECT_EQ(steps.found.size(), apart ? 1U : 0U);
  }
}

TEST(axes_path, arcs_are_pieces_that_miss_it_by_little) {
  Action action;
  Motion motion;
  motion.kind = MotionKind::arc_ccw;
  motion.to = motion.machine = {-50, 0, 0};
  motion.center = {0, 0};
  motion.turns = 0.5;
  action.what = motion;
  ToolPosition from;
  from.work = from.machine = {50, 0, 0};
  const Step step(roles, action, from);
  Axes at = from.machine;
  double worst = 0, last = 0;
  along_axes_path(step, 0.002, {}, [&](const Axes& to, double part) {
    worst = std::max(worst, 50 - std::hypot(0.5 * (at[0] + to[0]), 0.5 * (at[1] + to[1])));
    EXPECT_GT(part, last);
    at = to, last = part;
  });
  EXPECT_EQ(last, 1);
  EXPECT_EQ(at, motion.machine);
  EXPECT_LT(worst, 0.0021);
}

TEST(dog_leg, bends_where_an_axis_arrives) {
  Action action;
  Motion motion;
  motion.to = motion.machine = {100, -40, 10};
  action.what = motion;
  const ToolPosition from;
  const Step step(roles, action, from);
  const auto leg = DogLeg::of(step, Axes{1000, 800, 1000});
  ASSERT_TRUE(leg);
  ASSERT_EQ(leg->corners().size(), 3U);  // Z arrives after 0.1 s, Y after 0.5 s, X at the end
  EXPECT_NEAR(leg->corners()[0], 0.1, 1e-12);
  EXPECT_NEAR(leg->corners()[1], 0.5, 1e-12);
  EXPECT_EQ(leg->corners()[2], 1);
  EXPECT_NEAR(leg->gone(1, 0.25), 0.5, 1e-12);
  EXPECT_EQ(leg->gone(1, 0.75), 1);
  EXPECT_FALSE(DogLeg::of(step, std::nullopt));
  std::get<Motion>(action.what).kind = MotionKind::feed;
  EXPECT_FALSE(DogLeg::of(step, Axes{1000, 800, 1000}));
}

}  // namespace
}  // namespace kadr::machine_watch_test
