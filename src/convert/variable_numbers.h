#pragma once
// VariableNumbers: finds the number that a variable of the source control has on the target control. Variables that programs may use freely
// keep their number; system variables are matched by their meaning.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "config/control/control_def.h"

namespace kadr {

class VariableNumbers {
 public:
  ///   from, to  the source control and the target control; both must outlive this object
  VariableNumbers(const ControlDef& from, const ControlDef& to) : from_(from), to_(to) {}

  /// Returns the number of the corresponding variable on the target control; nullopt if that control has no such variable.
  std::optional<std::uint32_t> of(std::uint32_t number) const;

  /// Returns the name, such as "#100", that a variable with a value in the set-up has on the target control; nullopt if a set-up of the
  /// target control cannot give it a value.
  std::optional<std::string> given(const std::string& name) const;

 private:
  const ControlDef& from_;
  const ControlDef& to_;
  mutable std::map<std::uint32_t, std::optional<std::uint32_t>> known_;
};

}  // namespace kadr
