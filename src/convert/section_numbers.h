#pragma once
// SectionNumbers: numbers of subprograms on a control that keeps them in a section before the program (spec/s2c42 3): two digits, none that
// calls a cycle of its own. A subprogram keeps its number where that is one.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "config/control_def.h"

namespace kadr {

class SectionNumbers {
 public:
  explicit SectionNumbers(const ControlDef& to) : to_(to) {}

  /// The control keeps them so.
  bool are_there() const { return to_.grammar.section_address != 0; }
  /// Of a label, digits or a name; the same each time. Nothing: none is left.
  std::optional<std::uint32_t> of(const std::string& label);
  /// L0205: number 2 five times; nothing: more times than can be written.
  std::optional<std::string> call(const std::string& label, std::uint32_t times);

 private:
  bool is_free(std::uint32_t number) const;

  const ControlDef& to_;
  std::map<std::string, std::uint32_t> numbers_;
  std::set<std::uint32_t> taken_;
};

}  // namespace kadr
