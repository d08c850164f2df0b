// motion/time/steps: each step is at the position where all previous actions have led, with the time at which it happens. The slow
// reference adds up all actions from the start for each step.

#include "motion/time/steps.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "actions.h"

namespace kadr::steps_test {
namespace {

using test::arc;
using test::straight;
using enum MotionKind;

const AxisRoles roles = AxisRoles::of({"X", "Y", "Z"}, 0);

double any_place() { return *rc::gen::inRange(-1000, 1001) / 10.0; }

Action any_action() {
  const Axes work{any_place(), any_place(), any_place()};
  const Vec3 to{work[0], work[1], work[2]};
  Motion motion = straight(feed, to, 100);
  switch (*rc::gen::inRange(0, 6)) {
    case 0: return {{}, FrameChange{{.origin = {1, 2, 3}, .turn = std::make_shared<FrameTurn>()}, work}};
    case 1: return {{}, FrameChange{{.origin = {3, 2, 1}}, work}};
    case 2: return {{}, Dwell{0.25}};
    case 3: return {{}, ToolChange{3}};
    case 4: motion = arc(arc_ccw, to, {to.x + 5, to.y, to.z}, 0.5); break;
    default: break;
  }
  for (std::size_t a = 0; a < 3; ++a) motion.machine[a] = motion.to[a] + 100;
  return test::action(motion);
}

bool same(const ToolPosition& a, const ToolPosition& b) { return a.work == b.work && a.machine == b.machine && a.turn == b.turn; }

RC_GTEST_PROP(steps, stand_where_all_actions_before_have_led, ()) {
  const ToolPosition start{{1, 2, 3}, {4, 5, 6}, {}};
  std::vector<Action> program;
  for (int i = *rc::gen::inRange(0, 30); i > 0; --i) program.push_back(any_action());
  Steps steps(roles, start);
  for (std::size_t n = 0; n < program.size(); ++n)
    steps.give(program[n], [&](const Step& step) {
      ToolPosition folded = start;
      for (std::size_t i = 0; i < n; ++i) folded.take(program[i]);
      RC_ASSERT(same(step.from, folded));
      RC_ASSERT(&step.action == &program[n]);
      RC_ASSERT(step.time.seconds == 0);
    });
}

RC_GTEST_PROP(steps, times_and_pauses_add_up_to_those_of_the_clock, ()) {
  MachineProfile profile;
  profile.tool_change_s = 7;
  kadr::Setup setup;
  setup.machine["*"].rapid = 6000;
  TimeEstimate clock(roles, rates_of(profile, setup, {"X", "Y", "Z"})), twin = clock;
  Steps steps(roles, {}, &clock);
  ToolPosition at;
  double sum = 0;
  for (int i = 0; i < 20; ++i) {
    const Action action = any_action();
    steps.give(action, [&](const Step& step) {
      if (const Motion* const motion = step.motion()) {
        const MotionTime time = twin.motion(*motion, Curve(roles, at.work, *motion));
        RC_ASSERT(step.time.seconds == time.seconds);
        RC_ASSERT(step.time.length == time.length);
      } else {
        twin.other(action);
      }
      sum += step.time.seconds + step.pause;
    });
    at.take(action);
  }
  RC_ASSERT(clock.split().total() == twin.split().total());
  RC_ASSERT(std::abs(sum - clock.split().total()) <= 1e-9 * (1 + sum));
}

TEST(steps, begin_when_the_run_says) {
  Steps steps(roles, {});
  double begins = 0;
  steps.give({{}, Dwell{1}}, 12.5, [&](const Step& step) { begins = step.begins; });
  EXPECT_EQ(begins, 12.5);
  EXPECT_EQ(steps.position().work, Axes{});
}

}  // namespace
}  // namespace kadr::steps_test
