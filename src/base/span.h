#pragma once
// Span and Position: a range of bytes in a line of a program's source text, and the location of a block in its file.

#include <cstdint>

namespace kadr {

/// A range of bytes, [begin, end), in one line of the source text, which is UTF-8.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// The location of a block in its file. From this location the block can be read again.
struct Position {
  std::uint64_t offset = 0;  // byte offset of the block's line in the file
  std::uint32_t line = 1;    // line number of the block, counted from 1
  // Number of blocks that precede the block in its line (2С42: several blocks, separated by `ПС`, may share a line)
  std::uint32_t nth = 0;
  friend bool operator==(const Position&, const Position&) = default;
};

}  // namespace kadr
