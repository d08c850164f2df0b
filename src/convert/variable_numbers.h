#pragma once
// VariableNumbers: the number that a variable of one control has on another one. Free ones keep theirs; system variables are found by what
// they are.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "config/control_def.h"

namespace kadr {

class VariableNumbers {
 public:
  /// Both must outlive this.
  VariableNumbers(const ControlDef& from, const ControlDef& to) : from_(from), to_(to) {}

  /// Nothing: the other control has no such variable.
  std::optional<std::uint32_t> of(std::uint32_t number) const;

  /// The name there of one that a set-up gives a value: "#100"; nothing: none that can be given one.
  std::optional<std::string> given(const std::string& name) const;

 private:
  const ControlDef& from_;
  const ControlDef& to_;
  mutable std::map<std::uint32_t, std::optional<std::uint32_t>> known_;
};

}  // namespace kadr
