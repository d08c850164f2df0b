#pragma once
// BlockNumbers: the positions of the numbered blocks of one file, for GOTO n, M99 Pn, and P and Q of a turning cycle (nct 14.1, 14.4.4,
// 19.B, 23.2.8). The table is built in one pass through the file; each search in the table is a binary search. Tested by
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
  /// Returns whether a range of data lines begins with this block, ends with it, or neither.
  static Step step_of(const Block& block);
};

class BlockNumbers {
 public:
  /// Greatest number of table rows: 64 MB at 16 bytes each. If a file has more numbered blocks, searches read the file and the table is not
  /// used.
  static constexpr std::size_t most = 4'000'000;

  /// Builds the table by reading the whole file.
  ///   returns  false if the file has too many block numbers or `stop` was requested; then the table is empty
  bool make(BlockReader& reader, StopToken stop);

  /// Searches the block number `number` from `from` to the end of the file, then from the start of the file, and returns the first block
  /// found (nct 14.1, INFERRED order). A search that starts among data lines has not read the G10 before them, so it counts their N as
  /// block numbers up to the next G10.
  std::optional<Position> find(std::uint32_t number, Position from) const;

  std::size_t size() const { return rows_.size(); }

 private:
  struct Row {
    // 48 bits: byte offset of the block; 15 bits: number of earlier blocks in its line; 1 bit: the block is a data line.
    std::uint64_t place = 0;
    std::uint32_t number = 0;  // the number after N
    std::uint32_t line = 0;
  };
  static_assert(sizeof(Row) == 16);
  static std::uint64_t place_of(Position p) { return p.offset << 16 | std::uint64_t{p.nth} << 1; }
  bool counts_from(const Row& row, std::uint64_t from) const;

  std::vector<Row> rows_;                // one table row for each numbered block, sorted by block number, then by position
  std::vector<std::uint64_t> openings_;  // positions of the blocks with G10 L52 or L75 to L77, in the order of the file
};

}  // namespace kadr
