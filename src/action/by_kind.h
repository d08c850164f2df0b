#pragma once
// by_kind: asks an action what kind it is. Every kind is named, by a function that takes it or in ignores<…> or same<…>: a kind that is
// added to Action does not compile until each caller has decided what it means there.
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

/// Several functions as one; the argument decides which is called.
template <class... Functions>
struct EachKind : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
EachKind(Functions...) -> EachKind<Functions...>;

template <class Kind, class... Kinds>
concept IsOneOf = (std::same_as<Kind, Kinds> || ...);

/// Takes these kinds and does nothing.
template <class... Kinds>
struct Ignored {
  template <class Kind>
  requires IsOneOf<Kind, Kinds...>
  void operator()(const Kind&) const {}
};
template <class... Kinds>
inline constexpr Ignored<Kinds...> ignores{};

/// Takes these kinds and returns the same of each.
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

/// Calls the function that takes the action's kind, and returns what it returns: the same type for all kinds.
template <class... Functions>
auto by_kind(const Action& action, Functions&&... functions) {
  return std::visit(EachKind{std::forward<Functions>(functions)...}, action.what);
}

template <class... Functions>
auto by_kind(Action& action, Functions&&... functions) {
  return std::visit(EachKind{std::forward<Functions>(functions)...}, action.what);
}

/// Returns nullptr where the action is no motion: for those who look at nothing else.
inline const Motion* motion_of(const Action& action) { return std::get_if<Motion>(&action.what); }
inline Motion* motion_of(Action& action) { return std::get_if<Motion>(&action.what); }

/// A code that the control carries out itself, and that the machine is only told of (nct 13.1: M2, M30, M98, M99).
inline bool is_by_control(const Action& action) {
  const auto* const function = std::get_if<MachineFunction>(&action.what);
  return function != nullptr && function->by_control;
}

}  // namespace kadr
