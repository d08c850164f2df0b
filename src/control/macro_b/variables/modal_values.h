#pragma once
// #4001 … #4530: modal codes and words (spec/nct/23 23.1.14). Families: 0 buffered, 1 executing, 2 interrupted; the
// interpreter carries each block out before it reads the next: the first two are the same.

#include <cstdint>

namespace kadr {
class BlockContext;
}

namespace kadr::macro_b {

/// Code of a group: 100·decimal + whole part; 0: none.
double modal_group(const BlockContext& m, int family, std::uint32_t group);
/// A word by its letter; `arg` = 1000·family + letter (controls/nct.toml).
double modal_word(const BlockContext& m, int arg);

}  // namespace kadr::macro_b
