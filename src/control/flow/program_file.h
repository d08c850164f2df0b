#pragma once
// ProgramFile: one file of the program memory, with its reader, the blocks kept in memory for loops, and the positions of block numbers
// and loops (spec/nct/14, 23 23.2.8, 23.2.11).

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/stop_token.h"
#include "control/flow/block_numbers.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// A block stored as it was read, so that a loop compiles it only once.
struct KeptBlock {
  Block block;
  std::string text;
  Position next;
  KeptBlock* following = nullptr;  // the kept block at `next`
  KeptBlock* jumped = nullptr;     // the kept block that the last jump from here went to
  std::uint64_t jumped_to = 0;     // key (key_of) of the block `jumped`
};

/// DO … END of a file, paired by their order in the text.
struct Loop {
  Position begin;   // the block with DO
  Position body;    // first block after DO
  Position end;     // the block with END
  Position behind;  // first block after END
  AlarmId fault = no_alarm;
  std::uint8_t number = 0;  // 0: a WHILE without DO
  bool damaged = false;     // the DO or END block cannot be read; END then has no effect
};

class ProgramFile {
 public:
  ProgramFile(std::string path, std::shared_ptr<ByteSource> source, const Grammar& grammar, std::optional<Encoding> encoding,
              StopToken stop = {});

  /// Reads the next block; `block` points to it until the next call. If blocks are kept in memory, it may be a block that was read
  /// before.
  Result<BlockReader::Got> next(Block*& block);
  void seek(Position position) {
    elsewhere_ = position;
    moved_ = true;
  }
  Position position() const { return moved_ ? elsewhere_ : reader_.position(); }
  /// Records that the warnings of a kept block have been reported, so that they are reported once.
  void note_warned(const Block& block) {
    if (block.kept) memory_.told.insert(place_of(block.position));
  }
  /// State of reading that the run has left in the file; with the position in the program this is all that the run needs to continue.
  struct Memory {
    BlockReader::Memory reader;
    bool keeps = false;
    std::set<std::pair<std::uint64_t, std::uint32_t>> told{};  // positions of kept blocks whose warnings were reported
  };
  Memory memory() const {
    Memory now = memory_;
    now.reader = reader_.memory();
    return now;
  }
  void resume_from(const Memory& memory) {
    memory_ = memory;
    reader_.resume_from(memory.reader);
  }
  /// From now on keeps in memory the blocks that are read, because they will be read again.
  void keep_blocks() { memory_.keeps = true; }

  /// Returns the first block with number `number` from `from` to the end, then from the start of the file (nct 14.1, INFERRED order).
  /// The first few thousand blocks are searched by reading on; after that an index of all numbers of the file is built.
  std::optional<Position> find_number(std::uint32_t number, Position from);
  /// Returns the positions where a program O… with this number starts in the file (Grammar::programs_by_label).
  std::vector<Position> programs_numbered(std::uint32_t number);
  /// Returns the first block that contains more than a comment or the sign %.
  Position first_block();
  /// The loop whose DO (loop_from) or END (loop_to) is at `position`; nullptr if there is none.
  const Loop* loop_from(Position position);
  const Loop* loop_to(Position position);

  /// Returns the given lines as UTF-8 by number, without lines that do not exist. Reads through the file once.
  std::map<std::uint32_t, std::string> texts_of(const std::set<std::uint32_t>& lines) const;

  /// Returns one line as UTF-8; empty if it does not exist. The first call reads through the file, later calls read a few lines.
  std::string text_of(std::uint32_t line) const;

  const std::string& path() const { return path_; }
  const BlockReader& reader() const { return reader_; }
  BlockReader& reader() { return reader_; }
  const std::shared_ptr<ByteSource>& source() const { return source_; }
  std::string shown(std::string_view text, Span& place) const { return reader_.shown(text, place); }
  const Grammar& grammar() const { return grammar_; }

 private:
  static constexpr std::size_t max_kept = 4096;
  static constexpr std::size_t max_loops = 100'000;
  static constexpr std::size_t max_searched = 4096;  // blocks; in a short file, or if the target is near, no index is needed
  BlockReader& scanner();
  /// The range from the start of a program to the start of the next.
  struct Extent {
    Position begin, end;
  };
  Extent extent_of(Position place);
  void find_programs();
  std::optional<Position> in_index(std::uint32_t number, Position from, const Extent& in) const;
  std::optional<Position> search(std::uint32_t number, Position from, const Extent& in);
  std::optional<Position> scan(std::uint32_t number, Position from, Position to);
  void find_loops();
  static std::uint64_t key_of(Position at) { return at.offset << 16 | at.nth; }  // a line has at most 64 K blocks
  static std::pair<std::uint64_t, std::uint32_t> place_of(Position at) { return {at.offset, at.nth}; }
  Block* keep(Position at);
  KeptBlock* kept_at(Position place);

  std::string path_;
  std::shared_ptr<ByteSource> source_;
  const Grammar& grammar_;
  BlockReader reader_;
  std::unique_ptr<BlockReader> scanner_;  // reads other parts of the file, so that the current block keeps its text
  Block in_hand_;
  Position elsewhere_;                                                   // where the next block begins …
  bool moved_ = false;                                                   // … if not at the reader's position
  Memory memory_;                                                        // without the state of the reader
  KeptBlock* last_ = nullptr;                                            // the kept block that was returned last
  std::unordered_map<std::uint64_t, std::unique_ptr<KeptBlock>> kept_;   // by key
  std::map<std::pair<std::uint64_t, std::uint32_t>, Position> numbers_;  // {key of the search's first block; number} → block found
  std::vector<Loop> loops_;
  std::unordered_map<std::uint64_t, std::size_t> loops_by_begin_, loops_by_end_;
  bool loops_found_ = false;
  const Loop* last_loop_ = nullptr;  // the loop whose END was executed last
  std::size_t searched_ = 0;         // blocks read in searches for numbers
  std::optional<Position> first_block_;
  std::optional<BlockNumbers> index_;
  struct NumberedProgram {
    Position begin;
    std::uint32_t number = 0;
  };
  std::optional<std::vector<NumberedProgram>> programs_;  // starts of the programs in the file (Grammar::programs_by_label)
  bool index_possible_ = true;
  StopToken stop_;
  static constexpr std::uint32_t marked_line = 256;  // a mark is stored for every 256th line
  mutable std::vector<std::uint64_t> line_marks_;    // offsets of lines 1, 257, …
};

}  // namespace kadr
