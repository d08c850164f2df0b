#pragma once
// System variables that hold a bit each of something: signals, mirrored axes, the block search (spec/nct/23 23.1.7, 23.1.11).

#include <array>

namespace kadr {
class BlockContext;
}

namespace kadr::macro_b {
class MacroB;

double bits_to_word(const std::array<double, 32>& bits);
/// A bit an axis that is mirrored, by its control-wide number.
double mirror_bits(const BlockContext& m);
/// Of #_CNTBS (23.1.11): all three as a mask, or one.
double search_bits(const MacroB& n, int bit);

}  // namespace kadr::macro_b
