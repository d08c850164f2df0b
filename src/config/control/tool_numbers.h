#pragma once
// The numbers in a T word: the tool, and on some controls the offset in the last two digits, as in T0303.

#include <cstdint>

#include "config/control/control_def.h"

namespace kadr {

struct ToolNumbers {
  std::uint32_t tool = 0;
  std::uint32_t offset = 0;
  bool is_pair = false;  // the word states an offset too
};

/// Reads the value of a T word, which must not be negative.
inline ToolNumbers tool_numbers(const ControlDef& def, double value) {
  constexpr std::uint32_t hundred = 100;
  const auto number = static_cast<std::uint32_t>(value);
  const bool has_pairs = def.behaviour.tool_and_corrector || def.behaviour.lathe != Lathe::none;
  if (!has_pairs || number < hundred) return {number, 0, false};
  return {number / hundred, number % hundred, true};
}

}  // namespace kadr
