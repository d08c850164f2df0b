#include "config/function.h"

#include <algorithm>

#include "config/function_needs.h"

namespace kadr {
namespace {

constexpr FunctionTraits functions[] = {
#define KADR_FUNCTION_ROW(name, phase, axes, ...) {#name, Phase::phase, axes},
    KADR_FUNCTIONS(KADR_FUNCTION_ROW)
#undef KADR_FUNCTION_ROW
};

constexpr CalledBy callers[] = {
#define KADR_FUNCTION_CALLER(name, phase, axes, by, needs) CalledBy::by,
    KADR_FUNCTIONS(KADR_FUNCTION_CALLER)
#undef KADR_FUNCTION_CALLER
};

constexpr Needs all_needs[] = {
#define KADR_FUNCTION_NEEDS(name, phase, axes, by, needs) Needs::needs,
    KADR_FUNCTIONS(KADR_FUNCTION_NEEDS)
#undef KADR_FUNCTION_NEEDS
};

constexpr std::string_view phases[] = {
#define KADR_PHASE_NAME(name) #name,
    KADR_PHASES(KADR_PHASE_NAME)
#undef KADR_PHASE_NAME
};

}  // namespace

const FunctionTraits& traits_of(Function function) { return functions[static_cast<std::size_t>(function)]; }

CalledBy called_by(Function function) { return callers[static_cast<std::size_t>(function)]; }

Needs needs_of(Function function) { return all_needs[static_cast<std::size_t>(function)]; }

Function function_named(std::string_view name) {
  const auto* found = std::find_if(std::begin(functions), std::end(functions), [&](const FunctionTraits& row) { return row.name == name; });
  return static_cast<Function>(found - std::begin(functions));
}

Phase phase_named(std::string_view name) {
  return static_cast<Phase>(std::find(std::begin(phases), std::end(phases), name) - std::begin(phases));
}

std::string_view name_of(Phase phase) { return phases[static_cast<std::size_t>(phase)]; }

}  // namespace kadr
