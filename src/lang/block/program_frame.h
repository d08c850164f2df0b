#pragma once
// ProgramFrame: where a program starts and ends in its file. The record marks % give both positions. Text before the program is skipped
// (spec/fanuc 1.1, label skip).

#include <cstdint>
#include <string_view>

#include "lang/block/grammar.h"

namespace kadr {

struct ProgramFrame {
  static constexpr std::uint64_t none = ~std::uint64_t{0};
  std::uint64_t begin = 0;    // offset of the first line of the program
  std::uint64_t sign = none;  // offset of the line with the first %; none: the file has no %, or its first % is after the first block
};

/// Finds the start of the program in the first bytes of a file. If the text before the first % is not a block, it is a title and is
/// skipped.
ProgramFrame frame_of(std::string_view sample, const Grammar& grammar);

/// Returns true if the line starts with %, with or without blanks before it.
bool has_sign(std::string_view line);

}  // namespace kadr
