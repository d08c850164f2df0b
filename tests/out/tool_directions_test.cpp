// out/picture/tool_directions: marks at equal distances along the cutting path, bounded in number, none for an upright tool.

#include "out/picture/tool_directions.h"

#include <gtest/gtest.h>

#include "kinematics/five_axis_transform.h"

namespace kadr::tool_directions_test {
namespace {

/// Returns a head with axes A and C that leads the tip, as the NCT's G43.4 does.
std::shared_ptr<const WorkTransform> led_space() {
  FiveAxisTransformData data;
  data.machine.group = MachineGroup::head_head;
  data.machine.first = {4, {0, 0, 1}};
  data.machine.second = {3, {1, 0, 0}};
  data.follows_head = data.controls_tip = true;
  data.length = {0, 0, 100};
  return std::make_shared<const FiveAxisTransform>(data);
}

class Along {
 public:
  Along() {
    at_.space = led_space();
    at_.machine = at_.space->machine_of(at_.work, at_.work);
  }
  void go(double x, double a) {
    Motion motion;
    motion.kind = MotionKind::feed;
    motion.to = at_.work;
    motion.to[0] = x;
    motion.to[3] = a;
    motion.machine = at_.space->machine_of(motion.to, motion.to);
    const Action action{{}, motion};
    const Step step(roles_, action, at_);
    directions.take(step, {0, 0, 5});
    at_.work = motion.to;
    at_.machine = motion.machine;
  }
  ToolDirections directions{40};

 private:
  AxisRoles roles_ = AxisRoles::of({"X", "Y", "Z", "A", "C"}, 0b11000);
  ToolPosition at_;
};

TEST(tool_directions, at_even_distances_of_the_tip) {
  Along along;
  along.go(5, 30);
  const std::vector<ToolDirection> found = along.directions.leaning();
  ASSERT_GE(found.size(), 10U);
  ASSERT_LE(found.size(), 40U);
  const double apart = found[1].at.x - found[0].at.x;
  for (std::size_t i = 0; i + 1 < found.size(); ++i) EXPECT_NEAR(found[i + 1].at.x - found[i].at.x, apart, 1e-9);
  for (const ToolDirection& one : found) {
    EXPECT_NEAR(one.at.z, 5, 1e-9) << "the tip stays on its line, the picture is moved";
    const double lean = one.at.x / 5 * 30 * rad_per_deg;  // the tilt is proportional to the distance
    EXPECT_NEAR(one.direction.z, std::cos(lean), 1e-9);
    EXPECT_NEAR(std::fabs(one.direction.y), std::sin(lean), 1e-9);
  }
}

TEST(tool_directions, bounded_however_long_the_path_is) {
  Along along;
  for (int i = 0; i < 5000; ++i) along.go(i % 2 == 0 ? 100 : 0, i % 7);
  const std::vector<ToolDirection> found = along.directions.leaning();
  EXPECT_LT(found.size(), 40U);
  EXPECT_GT(found.size(), 10U);
}

TEST(tool_directions, nothing_of_a_tool_that_stands_upright) {
  Along along;
  along.go(50, 0);
  EXPECT_TRUE(along.directions.leaning().empty());
  along.go(60, 1);
  EXPECT_FALSE(along.directions.leaning().empty());
}

}  // namespace
}  // namespace kadr::tool_directions_test
