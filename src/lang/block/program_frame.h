#pragma once
// Where a program begins and ends in its file: the record mark % and the label skip (spec/fanuc 1.1).

#include <cstdint>
#include <string_view>

#include "lang/block/grammar.h"

namespace kadr {

struct ProgramFrame {
  static constexpr std::uint64_t none = ~std::uint64_t{0};
  std::uint64_t begin = 0;    // offset of the first line that is read
  std::uint64_t sign = none;  // of the line with the first %; none: there is none, or not before the first block
};

/// Looks at the beginning of a file. What stands before the first % is passed over where it is no block: a title.
ProgramFrame frame_of(std::string_view sample, const Grammar& grammar);

/// The line begins with %, blanks before it not counted.
bool has_sign(std::string_view line);

}  // namespace kadr
