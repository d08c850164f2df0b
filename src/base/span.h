#pragma once
// Where in the source text something stands.

#include <cstdint>

namespace kadr {

/// Range of bytes in one line of (UTF-8) source text: [begin, end).
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// Where a block stands in its file, enough to read it again.
struct Position {
  std::uint64_t offset = 0;  // byte offset of the line in the file
  std::uint32_t line = 1;    // counted from 1
  std::uint32_t nth = 0;     // blocks before it in the same line (several may stand between `ПС`)
  friend bool operator==(const Position&, const Position&) = default;
};

}  // namespace kadr
