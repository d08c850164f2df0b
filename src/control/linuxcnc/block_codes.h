#pragma once
// Sorts the codes of a block by modal group, decides which code commands the motion, and checks the block as a whole before any part of the
// block is executed (spec/linuxcnc 2.5, 2.7, 2.8).

#include <array>
#include <cstdint>

#include "base/code_literals.h"
#include "base/result.h"
#include "control/linuxcnc/modal_groups.h"

namespace kadr {
class BlockContext;
}

namespace kadr::linuxcnc {

class LinuxCnc;

/// The codes of a block, in tenths: G38.2 is 382. The value -1 means that the block has no such code.
struct BlockCodes {
  std::array<std::int32_t, g_groups> g{};  // G code of the block in each modal group, by group number
  std::array<std::int32_t, m_groups> m{};
  std::int32_t motion = -1;  // motion code of the block, or the one in force if the block has none; -1: no axis moves
  bool has_axis = false;     // the block has an axis word: X Y Z A B C U V W
  bool has_polar = false;    // the block has a polar word, @ or ^
  bool axes_for_group0 = false;

  std::int32_t g1() const { return g[1]; }
  bool has_g(int group, std::int32_t tenths) const { return g[static_cast<std::size_t>(group)] == tenths; }
  bool is_cycle() const { return motion == 73_g || motion == 74_g || (motion >= 81_g && motion <= 89_g); }
};

/// Reads and checks the codes and words of the interpreter's block.
///   alarms  rs274_form, rs274_codes, rs274_words, rs274_motion, rs274_data, rs274_arc, rs274_cycle
Result<BlockCodes> codes_of_block(BlockContext& m, const LinuxCnc& control);

}  // namespace kadr::linuxcnc
