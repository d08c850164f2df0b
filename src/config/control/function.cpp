// The table of the engine's functions: finds a function by its name, and a name by its function. Used by config, control; tested by
// tests/config/function_test.cpp.

#include "config/control/function.h"

#include <algorithm>

namespace kadr {
namespace {

constexpr FunctionTraits row(std::string_view name, Phase phase, TakesAxes axes, CalledBy by, Needs needs, FunctionOrder order,
                             std::uint8_t facts) {
  return {name, phase, axes, by, needs, order, facts};
}

using namespace function_fact;

constexpr FunctionTraits functions[] = {
#define KADR_FUNCTION_ROW(name, phase, axes, by, needs, order, facts) \
  row(#name, Phase::phase, TakesAxes::axes, CalledBy::by, Needs::needs, FunctionOrder::order, facts),
    KADR_FUNCTIONS(KADR_FUNCTION_ROW)
#undef KADR_FUNCTION_ROW
};

constexpr std::string_view phases[] = {
#define KADR_PHASE_NAME(name) #name,
    KADR_PHASES(KADR_PHASE_NAME)
#undef KADR_PHASE_NAME
};

}  // namespace

const FunctionTraits& traits_of(Function function) { return functions[static_cast<std::size_t>(function)]; }

Function function_named(std::string_view name) {
  const auto* found = std::find_if(std::begin(functions), std::end(functions), [&](const FunctionTraits& row) { return row.name == name; });
  return static_cast<Function>(found - std::begin(functions));
}

Phase phase_named(std::string_view name) {
  return static_cast<Phase>(std::find(std::begin(phases), std::end(phases), name) - std::begin(phases));
}

std::string_view name_of(Phase phase) { return phases[static_cast<std::size_t>(phase)]; }

}  // namespace kadr
