#pragma once
// System variables that are bit masks: signals, mirrored axes, the block search (spec/nct/23 23.1.7, 23.1.11).

#include <array>

namespace kadr {
class BlockContext;
}

namespace kadr::macro_b {
class MacroB;

double bits_to_word(const std::array<double, 32>& bits);
/// Returns a mask with one bit for each mirrored axis. Bit 0 is the axis with number 1; the numbers count the axes of all channels.
double mirror_bits(const BlockContext& m);
/// Returns the block search variable #_CNTBS (23.1.11): one of its three bits, or all three as a mask if `bit` is negative.
double search_bits(const MacroB& n, int bit);

}  // namespace kadr::macro_b
