// config/control/function: the name of each function and phase leads back to that function or phase.

#include "config/control/function.h"

#include <gtest/gtest.h>

#include <set>

namespace kadr::function_test {
namespace {

TEST(functions, names_lead_back) {
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i < static_cast<std::size_t>(Function::count); ++i) {
    const auto function = static_cast<Function>(i);
    EXPECT_EQ(function_named(traits_of(function).name), function) << traits_of(function).name;
    EXPECT_TRUE(seen.insert(traits_of(function).name).second) << traits_of(function).name << " twice";
    EXPECT_LT(traits_of(function).phase, Phase::count);
  }
  for (const char* name : {"", "count", "Rapid", "rapid "}) EXPECT_EQ(function_named(name), Function::count) << name;
}

TEST(phases, names_lead_back) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(Phase::count); ++i)
    EXPECT_EQ(phase_named(name_of(static_cast<Phase>(i))), static_cast<Phase>(i));
  EXPECT_EQ(phase_named("count"), Phase::count);
}

TEST(functions, that_move_take_the_axis_words) {
  for (const Function f :
       {Function::rapid, Function::linear, Function::arc_cw, Function::arc_ccw, Function::cycle, Function::probe, Function::set_position})
    EXPECT_TRUE(traits_of(f).takes_axes()) << traits_of(f).name;
  for (const Function f : {Function::plane_xy, Function::absolute, Function::dwell, Function::spindle_cw, Function::machine_coordinates})
    EXPECT_FALSE(traits_of(f).takes_axes()) << traits_of(f).name;
}

}  // namespace
}  // namespace kadr::function_test
