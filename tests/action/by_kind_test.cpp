// action/by_kind: dispatches each kind of action to the function that accepts it; a kind that no function accepts does not compile.

#include "action/by_kind.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace kadr::by_kind_test {
namespace {

template <class... Functions>
EachKind<Functions...> each(Functions...);

using WithoutDwell = decltype(each(same<Motion, Spindle>(1), [](const Stop&) { return 2; }));
static_assert(std::is_invocable_r_v<int, WithoutDwell, const Motion&>);
static_assert(std::is_invocable_r_v<int, WithoutDwell, const Stop&>);
static_assert(!std::is_invocable_v<WithoutDwell, const Dwell&>);
static_assert(!std::is_invocable_v<Ignored<Motion, Spindle>, const Dwell&>);
static_assert(std::is_invocable_v<Ignored<Motion, Dwell>, const Dwell&>);

std::string name_of(const Action& action) {
  return by_kind(
      action, [](const Dwell& dwell) { return "dwell " + std::to_string(int(dwell.seconds)); },
      [](const Stop& stop) { return std::string(stop.optional ? "M1" : "M0"); },
      same<Motion, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Message, FrameChange,
           SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>(
          std::string("another")));
}

TEST(by_kind, calls_the_function_of_the_kind) {
  EXPECT_EQ(name_of({{}, Dwell{3}}), "dwell 3");
  EXPECT_EQ(name_of({{}, Stop{true}}), "M1");
  EXPECT_EQ(name_of({{}, Speed{100, false}}), "another");
}

TEST(by_kind, may_change_what_it_is_given) {
  Action action{{}, Dwell{3}};
  by_kind(
      action, [](Dwell& dwell) { dwell.seconds = 5; },
      ignores<Motion, Spindle, Speed, CoolantSwitch, ToolSelect, ToolChange, MachineFunction, AuxiliaryFunction, Stop, Message, FrameChange,
              SurfaceSpeed, Sync, ZoneChange, Couple, Uncouple, CompensationBreak, CompensationCorner, CompensationCheck>);
  EXPECT_EQ(name_of(action), "dwell 5");
}

TEST(by_kind, tells_motions_and_codes_of_the_control) {
  MachineFunction end;
  end.by_control = true;
  EXPECT_TRUE(is_by_control({{}, end}));
  EXPECT_FALSE(is_by_control({{}, MachineFunction{}}));
  EXPECT_FALSE(is_by_control({{}, Motion{}}));
  const Action moves{{}, Motion{}}, waits{{}, Dwell{}};
  EXPECT_EQ(motion_of(moves), &std::get<Motion>(moves.what));
  EXPECT_EQ(motion_of(waits), nullptr);
}

}  // namespace
}  // namespace kadr::by_kind_test
