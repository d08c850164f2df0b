// kinematics/machine_links: the positions of a machine's links, and the bound of their travel.

#include "kinematics/machine_links.h"

#include <gtest/gtest.h>

#include <random>

namespace kadr::machine_links_test {
namespace {

const std::vector<std::string> five_axes = {"X", "Y", "Z", "A", "C", "B"};

MachineLinks links_of(const char* machine) { return MachineLinks(MachineTree(*load_machine(machine), five_axes)); }

Axes some_axes(std::mt19937& random, double linear, double rotary) {
  std::uniform_real_distribution<double> one(-1, 1);
  Axes axes{};
  for (std::size_t i = 0; i < five_axes.size(); ++i) axes[i] = (i < 3 ? linear : rotary) * one(random);
  return axes;
}

// law: the tool as seen from the part is where MachineTree::forward puts it.
TEST(machine_links, poses_are_those_of_the_tree) {
  std::mt19937 random(1);
  for (const char* machine : {"table-table", "head-table", "head-head", "nct-vmc"}) {
    const auto profile = load_machine(machine);
    const MachineTree tree(*profile, five_axes);
    const MachineLinks links(tree);
    std::vector<LinkPose> poses;
    for (int i = 0; i < 100; ++i) {
      const Axes axes = some_axes(random, 400, 170);
      links.poses(axes, poses);
      const Pose pose = tree.forward(axes, 120);
      const LinkPose& tool = poses[links.tool()];
      const LinkPose& part = poses[links.part()];
      EXPECT_LT(length(part.back(tool.of({0, 0, -120})) - pose.tip), 1e-9) << machine;
      EXPECT_LT(length(turned_back(part.turn, tool.turn * Vec3{0, 0, 1}) - pose.direction), 1e-12) << machine;
    }
  }
}

TEST(machine_links, carriers) {
  const MachineLinks links = links_of("table-table");  // link of X, Z | link of Y, A, C
  EXPECT_EQ(links.count(), 6U);
  EXPECT_EQ(links.tool(), 2U);
  EXPECT_EQ(links.part(), 5U);
  EXPECT_EQ(links.moved_by("Z"), 2U);
  EXPECT_EQ(links.moved_by("bed"), MachineLinks::bed);
  EXPECT_EQ(links.carrier(2, 5), MachineLinks::bed);
  EXPECT_EQ(links.carrier(3, 5), 3U);
  EXPECT_EQ(links.carrier(1, 2), 1U);
  EXPECT_TRUE(links.carries_tool(1));
  EXPECT_FALSE(links.carries_tool(3));
}

// law: at any fraction of a motion, no point of a body has moved farther than the bound, seen from any link that carries the body.
TEST(machine_links, travel_is_a_bound) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> one(-1, 1);
  for (const char* machine : {"table-table", "head-table", "head-head"}) {
    const MachineLinks links = links_of(machine);
    std::vector<LinkPose> start, then;
    for (int i = 0; i < 300; ++i) {
      const Axes from = some_axes(random, 300, 150), by = some_axes(random, i % 3 == 0 ? 0 : 100, i % 3 == 1 ? 0 : 60);
      links.poses(from, start);
      const std::size_t link = 1 + std::size_t(i) % (links.count() - 1), other = i % 2 == 0 ? MachineLinks::bed : links.carrier(link, 1);
      const Vec3 middle{200 * one(random), 200 * one(random), 200 * one(random)};
      const double radius = 50;
      const Travel travel = links.travel(link, other, {start[link].of(middle), radius}, start, by);
      for (const double s : {0.1, 0.5, 1.0}) {
        Axes at = from;
        for (std::size_t a = 0; a < five_axes.size(); ++a) at[a] += s * by[a];
        links.poses(at, then);
        for (const Vec3 side : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}) {
          const Vec3 place = middle + radius * side;
          // The displacement seen from the other link, in the directions that this link has at the start.
          const Vec3 moved = start[other].turn * (then[other].back(then[link].of(place)) - start[other].back(start[link].of(place)));
          EXPECT_LE(length(moved), s * (length(travel.together) + travel.besides) + 1e-9) << machine;
          if (travel.besides == 0) {
            EXPECT_LT(length(moved - s * travel.together), 1e-9);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace kadr::machine_links_test
