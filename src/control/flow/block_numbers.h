#pragma once
// BlockNumbers: the positions of the numbered blocks of one file, for GOTO n, M99 Pn, P and Q of a turning cycle (nct 14.1, 14.4.4, 19.B,
// 23.2.8). The table is built in one pass through the file; each search in it is a binary one. Tested by
// tests/control/program_file_test.cpp.

#include <cstdint>
#include <optional>
#include <vector>

#include "base/stop_token.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// Recognises data lines (G10 L52 … G11), whose N is not a block number (nct 14.1).
class DataLines {
 public:
  enum class Step : std::uint8_t { none, begins, ends };
  /// Returns whether data lines begin or end with this block.
  static Step step_of(const Block& block);
};

class BlockNumbers {
 public:
  /// maximum number of table rows of 16 bytes: 64 MB. In a file with more numbered blocks, searches read the file instead.
  static constexpr std::size_t most = 4'000'000;

  /// Reads the whole file.
  ///   returns  false if there are too many numbers or `stop` was requested; then nothing is stored
  bool make(BlockReader& reader, StopToken stop);

  /// Returns the first block with number `number` from `from` to the end, then from the start of the file (nct 14.1, INFERRED order). A
  /// search that starts among data lines has not seen the G10 before them: up to the next G10 it reads N as a block number.
  std::optional<Position> find(std::uint32_t number, Position from) const;

  std::size_t size() const { return rows_.size(); }

 private:
  struct Row {
    std::uint64_t place = 0;   // byte offset of the block, 48 bits; number of blocks before it in its line, 15 bits; 1 bit: a data line
    std::uint32_t number = 0;  // N
    std::uint32_t line = 0;
  };
  static_assert(sizeof(Row) == 16);
  static std::uint64_t place_of(Position p) { return p.offset << 16 | std::uint64_t{p.nth} << 1; }
  bool counts_from(const Row& row, std::uint64_t from) const;

  std::vector<Row> rows_;                // sorted by number, then by position
  std::vector<std::uint64_t> openings_;  // positions of G10 L52, L75 to L77, in the order of the file
};

}  // namespace kadr
