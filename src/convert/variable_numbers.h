#pragma once
// VariableNumbers: the number that a variable of one control has on another one. Free ones keep theirs; system variables are found by what
// they are.

#include <cstdint>
#include <map>
#include <optional>

#include "config/control_def.h"

namespace kadr {

class VariableNumbers {
 public:
  /// Both must outlive this.
  VariableNumbers(const ControlDef& from, const ControlDef& to) : from_(from), to_(to) {}

  /// Nothing: the other control has no such variable.
  std::optional<std::uint32_t> of(std::uint32_t number) const;

 private:
  const ControlDef& from_;
  const ControlDef& to_;
  mutable std::map<std::uint32_t, std::optional<std::uint32_t>> known_;
};

}  // namespace kadr
