// System variables that are bit masks (spec/nct/23 23.1.7, 23.1.11). Used by control/macro_b/variables/system_variables.

#include "control/macro_b/variables/machine_bits.h"

#include "control/block_context.h"
#include "control/macro_b/macro_b.h"

namespace kadr::macro_b {

double bits_to_word(const std::array<double, 32>& bits) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < bits.size(); ++i)
    if (bits[i] != 0) word |= 1u << i;
  return word;
}

double mirror_bits(const BlockContext& m) {
  std::uint32_t bits = 0;
  for (std::size_t a = 0; a < m.axis_count; ++a)
    if (m.transform.mirror[a] < 0 && m.def.axis_numbers[a] >= 1) bits |= 1u << (m.def.axis_numbers[a] - 1u);
  return bits;
}

double search_bits(const MacroB& n, int bit) {
  constexpr const char* names[] = {"BSEARCH", "TEST", "MCHLOCK"};
  unsigned bits = 0;
  for (unsigned i = 0; i < 3; ++i)
    if (const auto found = n.signals.find(names[i]); found != n.signals.end() && found->second != 0) bits |= 1U << i;
  return bit < 0 ? bits : bits >> bit & 1U;
}

}  // namespace kadr::macro_b
