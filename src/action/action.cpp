#include "action/action.h"

#include <utility>

namespace kadr {

Action::Action() = default;
Action::Action(Origin by, What that) : origin(by), what(std::move(that)) {}
Action::Action(const Action&) = default;
Action::Action(Action&&) noexcept = default;
Action& Action::operator=(const Action&) = default;
Action& Action::operator=(Action&&) noexcept = default;
Action::~Action() = default;

}  // namespace kadr
