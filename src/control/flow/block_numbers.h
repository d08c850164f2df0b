#pragma once
// Where the numbered blocks of one file stand: GOTO n, M99 Pn, P and Q of a turning cycle (nct 14.1, 14.4.4, 19.B, 23.2.8).
// Made in one pass through the file; then each search is a binary one. Tested by tests/control/program_file_test.cpp.

#include <cstdint>
#include <optional>
#include <vector>

#include "base/stop.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// N of data lines (G10 L52 … G11) is no block number (nct 14.1).
class DataLines {
 public:
  enum class Step : std::uint8_t { none, begins, ends };
  /// What the block does to those after it.
  static Step step_of(const Block& block);
};

class BlockNumbers {
 public:
  /// 16 bytes each: 64 MB. Of a file with more the searches read it as they did before.
  static constexpr std::size_t most = 4'000'000;

  /// Reads all of the file.
  ///   returns  false: too many numbers, or `stop` was asked; nothing is kept then
  bool make(BlockReader& reader, StopToken stop);

  /// First block numbered `number` from `from` to the end, then from the beginning (nct 14.1, INFERRED order).
  /// A search that begins among data lines has not seen their G10: there N are numbers up to the next G10.
  std::optional<Position> find(std::uint32_t number, Position from) const;

  std::size_t size() const { return rows_.size(); }

 private:
  struct Row {
    std::uint64_t place = 0;   // offset, 48 bits; blocks before it in its line, 15 bits; 1: among data lines
    std::uint32_t number = 0;  // N
    std::uint32_t line = 0;
  };
  static_assert(sizeof(Row) == 16);
  static std::uint64_t place_of(Position p) { return p.offset << 16 | std::uint64_t{p.nth} << 1; }
  bool counts_from(const Row& row, std::uint64_t from) const;

  std::vector<Row> rows_;                // by number, then as in the file
  std::vector<std::uint64_t> openings_;  // places of G10 L52, L75 to L77, as in the file
};

}  // namespace kadr
