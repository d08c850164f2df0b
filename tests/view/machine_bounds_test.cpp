// view/machine_bounds: the end positions and zones that are in force at the start.

#include "view/machine_bounds.h"

#include <gtest/gtest.h>

#include "view/program_run.h"

namespace kadr::machine_bounds_test {
namespace {

MachineBounds bounds_of(const std::string& control, const Setup& setup) {
  OpeningRequest request;
  request.path = "machine_bounds_test.nc";
  request.control = control;
  request.text = "G0 X1\nM30\n";
  auto opened = open_for_page(request);
  EXPECT_TRUE(opened) << opened.error();
  opened->setup = setup;
  auto run = ProgramRun::make(*opened, {});
  EXPECT_TRUE(run) << run.error();
  return machine_bounds((*run)->opened(), (*run)->control());
}

TEST(MachineBounds, WithoutLimitsThereIsNone) {
  const MachineBounds space = bounds_of("mach3", {});
  EXPECT_EQ(space.limits.least[0], std::nullopt);
  EXPECT_EQ(space.limits.most[2], std::nullopt);
  EXPECT_TRUE(space.zones.empty());
}

TEST(MachineBounds, EndPositionsOfTheSetUp) {
  kadr::Setup setup;
  setup.machine["X"].limits = {-10, 300};
  setup.machine["*"].limits = {-50, 60};
  const MachineBounds space = bounds_of("mach3", setup);
  EXPECT_EQ(space.limits.least[0], -10);
  EXPECT_EQ(space.limits.most[0], 300);
  EXPECT_EQ(space.limits.least[2], -50);
}

TEST(MachineBounds, ZonesOfTheParameters) {
  kadr::Setup setup;
  setup.machine["X"].zone3 = {1, 2};
  for (const auto& [name, value] :
       {std::pair("N1000.X#2", 1.0), {"N1001#1", 1.0}, {"N1000.X#1", 1.0}, {"N1006.X", 50.0}, {"N1007.X", -5.0}})
    setup.parameters[*parameter_key(name)] = value;
  const MachineBounds space = bounds_of("nct", setup);
  ASSERT_EQ(space.zones.size(), 2U);
  EXPECT_EQ(space.zones[0].number, 2);
  EXPECT_TRUE(space.zones[0].inside);
  EXPECT_EQ(space.zones[0].box.most[0], 50);
  EXPECT_EQ(space.zones[1].number, 3);
  EXPECT_EQ(space.zones[1].box.least[0], 1);
  EXPECT_EQ(space.zones[1].box.most[1], std::nullopt);
}

}  // namespace
}  // namespace kadr::machine_bounds_test
