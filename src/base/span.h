#pragma once
// Span and Position: locations in the source text.

#include <cstdint>

namespace kadr {

/// Range of bytes in one line of (UTF-8) source text: [begin, end).
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// The location of a block in its file, sufficient to read the block again.
struct Position {
  std::uint64_t offset = 0;  // byte offset of the line in the file
  std::uint32_t line = 1;    // counted from 1
  // Number of blocks that precede the block in its line (2С42: several blocks, separated by `ПС`, may share a line)
  std::uint32_t nth = 0;
  friend bool operator==(const Position&, const Position&) = default;
};

}  // namespace kadr
