#pragma once
// System variables #4001 … #4530: modal codes and words (spec/nct/23 23.1.14). `family` selects the block: 0 the block in the look-ahead
// buffer, 1 the block being executed, 2 the interrupted block. The interpreter executes each block before it reads the next, so families
// 0 and 1 are equal.

#include <cstdint>

namespace kadr {
class BlockContext;
}

namespace kadr::macro_b {

/// Returns the G code in force of a modal group as 100·decimal + whole part (a code with a decimal is above 100); 0 if the group has no
/// code in force.
double modal_group(const BlockContext& m, int family, std::uint32_t group);
/// Returns the value of a modal word. `arg` = 1000·family + character code of the word's letter (controls/nct.toml).
double modal_word(const BlockContext& m, int arg);

}  // namespace kadr::macro_b
