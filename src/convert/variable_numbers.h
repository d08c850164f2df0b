#pragma once
// VariableNumbers: finds the number that a variable of one control has on another one. Free variables keep their number; system variables
// are matched by their meaning.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "config/control_def.h"

namespace kadr {

class VariableNumbers {
 public:
  /// Both must outlive this object.
  VariableNumbers(const ControlDef& from, const ControlDef& to) : from_(from), to_(to) {}

  /// Returns nullopt if the other control has no such variable.
  std::optional<std::uint32_t> of(std::uint32_t number) const;

  /// Returns the other control's name, "#100", of a variable that a set-up gives a value; nullopt if no set-up there can give it one.
  std::optional<std::string> given(const std::string& name) const;

 private:
  const ControlDef& from_;
  const ControlDef& to_;
  mutable std::map<std::uint32_t, std::optional<std::uint32_t>> known_;
};

}  // namespace kadr
