#pragma once
// SectionNumbers: assigns numbers to subprograms for a control that has its subprograms in a section before the main program (spec/s2c42
// 3). A number has two digits and must not be the number of a built-in canned cycle. A subprogram whose number meets these conditions keeps
// it.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "config/control/control_def.h"

namespace kadr {

class SectionNumbers {
 public:
  explicit SectionNumbers(const ControlDef& to) : to_(to) {}

  /// True if the target control has a section of subprograms.
  bool are_there() const { return to_.grammar.section_address != 0; }
  /// Returns the number for a label (digits or a name), the same number in each call; nullopt if no number is free.
  std::optional<std::uint32_t> of(const std::string& label);
  /// Returns the word that calls the subprogram: L0205 calls subprogram 2 five times; nullopt if the word cannot express so many
  /// repetitions.
  std::optional<std::string> call(const std::string& label, std::uint32_t times);

 private:
  bool is_free(std::uint32_t number) const;

  const ControlDef& to_;
  std::map<std::string, std::uint32_t> numbers_;
  std::set<std::uint32_t> taken_;
};

}  // namespace kadr
