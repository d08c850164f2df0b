#pragma once
// by_kind(): calls one of several functions, selected by the kind of an action. A caller names every kind, either with a function that
// accepts it or in ignores<…> or same<…>. So when a kind is added to Action, no caller compiles until it handles the new kind.
//
//   by_kind(
//       action,                                                   //
//       [&](const Dwell& dwell) { seconds += dwell.seconds; },    //
//       ignores<Motion, Spindle, Speed /* and all the others */>);

#include <concepts>
#include <type_traits>
#include <utility>
#include <variant>

#include "action/action.h"

namespace kadr {

/// Combines several functions into one object with overloads, one for each kind of action.
template <class... Functions>
struct EachKind : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
EachKind(Functions...) -> EachKind<Functions...>;

template <class Kind, class... Kinds>
concept IsOneOf = (std::same_as<Kind, Kinds> || ...);

/// A function for by_kind() that accepts actions of these kinds and does nothing.
template <class... Kinds>
struct Ignored {
  template <class Kind>
  requires IsOneOf<Kind, Kinds...>
  void operator()(const Kind&) const {}
};
template <class... Kinds>
inline constexpr Ignored<Kinds...> ignores{};

/// A function for by_kind() that accepts actions of these kinds and returns the same value for each.
template <class Result, class... Kinds>
struct SameOf {
  Result result;
  template <class Kind>
  requires IsOneOf<Kind, Kinds...> Result operator()(const Kind&) const { return result; }
};
template <class... Kinds, class Result>
SameOf<Result, Kinds...> same(Result result) {
  return {std::move(result)};
}

/// Calls the function that accepts the action's kind, and returns the result of that function. All functions must have the same result
/// type.
template <class... Functions>
auto by_kind(const Action& action, Functions&&... functions) {
  return std::visit(EachKind{std::forward<Functions>(functions)...}, action.what);
}

template <class... Functions>
auto by_kind(Action& action, Functions&&... functions) {
  return std::visit(EachKind{std::forward<Functions>(functions)...}, action.what);
}

/// Returns the motion of the action; nullptr if the action is not a motion. For callers that process motions only.
inline const Motion* motion_of(const Action& action) { return std::get_if<Motion>(&action.what); }
inline Motion* motion_of(Action& action) { return std::get_if<Motion>(&action.what); }

/// Returns true for an M code that the control executes itself and only reports to the machine (nct 13.1: M2, M30, M98, M99).
inline bool is_by_control(const Action& action) {
  const auto* const function = std::get_if<MachineFunction>(&action.what);
  return function != nullptr && function->by_control;
}

}  // namespace kadr
