#pragma once
// #4001 … #4530: modal codes and words (spec/nct/23 23.1.14). Families: 0 buffered, 1 executing, 2 interrupted. The interpreter
// executes each block before it reads the next, so the first two are equal.

#include <cstdint>

namespace kadr {
class BlockContext;
}

namespace kadr::macro_b {

/// The code in force of a modal group: 100·decimal + whole part; 0 if there is none.
double modal_group(const BlockContext& m, int family, std::uint32_t group);
/// The value of a word by its letter; `arg` = 1000·family + letter (controls/nct.toml).
double modal_word(const BlockContext& m, int arg);

}  // namespace kadr::macro_b
