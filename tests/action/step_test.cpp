// action/step: the curve of a step equals the curve of its motion and is built
// once. A kept step stays the same when everything it was built from is gone.

#include "action/step.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <memory>

#include "actions.h"
#include "random_motion.h"

namespace kadr::step_test {
namespace {

using test::any_motion;
using test::Moved;

constexpr std::array<double, 6> parts{0, 0.13, 0.5, 0.77, 0.999, 1};

void same_curve(const Curve& a, const Curve& b) {
  RC_ASSERT(a.length() == b.length());
  RC_ASSERT(a.straight() == b.straight());
  RC_ASSERT(a.rotary_length() == b.rotary_length());
  RC_ASSERT(a.extents().least == b.extents().least);
  RC_ASSERT(a.extents().most == b.extents().most);
  for (const double part : parts) RC_ASSERT(a.at(part) == b.at(part));
}

RC_GTEST_PROP(step, its_curve_is_that_of_the_motion_from_where_the_tool_stands, ()) {
  const Moved moved = any_motion();
  const Action action = test::action(moved.motion);
  const Step step(moved.roles, action, moved.from);
  same_curve(step.curve(), Curve(moved.roles, moved.from.work, moved.motion));
  RC_ASSERT(&step.curve() == &step.curve());
  RC_ASSERT(step.motion() == &std::get<Motion>(action.what));
}

RC_GTEST_PROP(step, kept_outlives_what_it_was_made_of, ()) {
  const Moved moved = any_motion();
  auto action = std::make_unique<Action>(test::action(moved.motion, 7));
  auto from = std::make_unique<ToolPosition>(moved.from);
  auto roles = std::make_unique<AxisRoles>(moved.roles);
  const KeptStep kept(Step(*roles, *action, *from, 2.5, {1, 2, 3, 4, true, {}}, 0.5));
  action.reset();
  from.reset();
  roles.reset();
  const Step step = kept.step();
  same_curve(step.curve(), Curve(moved.roles, moved.from.work, moved.motion));
  RC_ASSERT(step.action.origin.line == 7U);
  RC_ASSERT(step.from.work == moved.from.work);
  RC_ASSERT(step.from.machine == moved.from.machine);
  RC_ASSERT(step.from.turn == moved.from.turn);
  RC_ASSERT(step.begins == 2.5);
  RC_ASSERT(step.time.seconds == 2);
  RC_ASSERT(step.time.exact);
  RC_ASSERT(step.pause == 0.5);
}

TEST(step, of_another_action_is_no_motion) {
  const AxisRoles roles;
  const ToolPosition from;
  const Action dwell{{}, Dwell{2}};
  EXPECT_EQ(Step(roles, dwell, from).motion(), nullptr);
}

}  // namespace
}  // namespace kadr::step_test
