#pragma once
// ProgramFile: one file of the program memory. It has the reader of the file, the blocks kept in memory for loops, and the positions of
// block numbers and loops (spec/nct/14, 23 23.2.8, 23.2.11).

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

/// A block that is kept in memory as it was read. If a loop executes the block again, it is not compiled a second time.
struct KeptBlock {
  Block block;
  std::string text;
  Position next;
  KeptBlock* following = nullptr;  // block kept in memory that follows this one, at the position `next`
  KeptBlock* jumped = nullptr;     // block kept in memory to which this block jumped last
  std::uint64_t jumped_to = 0;     // position of the block `jumped`, packed into one number by key_of()
};

/// A loop DO … END of a file. DO and END belong together by their order in the text, not by the order of execution.
struct Loop {
  Position begin;      // position of the block with DO
  Position body;       // position of the first block after DO
  Position end;        // position of the block with END
  Position after_end;  // position of the first block after END
  AlarmId fault = no_alarm;
  std::uint8_t number = 0;  // number m of DOm; 0: a WHILE without DO
  bool damaged = false;     // the block with DO or END cannot be read; such an END has no effect
};

class ProgramFile {
 public:
  ProgramFile(std::string path, std::shared_ptr<ByteSource> source, const Grammar& grammar, std::optional<Encoding> encoding,
              StopToken stop = {});

  /// Reads the next block. `block` points to it until the next call. The block may be one that was read earlier and is kept in memory.
  Result<BlockReader::Got> next(Block*& block);
  void seek(Position position) {
    elsewhere_ = position;
    moved_ = true;
  }
  Position position() const { return moved_ ? elsewhere_ : reader_.position(); }
  /// Records that the warnings of a kept block have been reported, so that they are reported only once.
  void note_warned(const Block& block) {
    if (block.repeated) memory_.reported.insert(place_of(block.position));
  }
  /// The state of the file object that the run has changed. With this state and the position in the program, a run can be continued.
  struct Memory {
    BlockReader::Memory reader;
    bool keeps = false;
    std::set<std::pair<std::uint64_t, std::uint32_t>> reported{};  // positions of kept blocks whose warnings were reported
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
  /// Starts keeping in memory the blocks that are read, because the program will read them again.
  void keep_blocks() { memory_.keeps = true; }

  /// Searches the block number `number` from `from` to the end of the file, then from the start of the file, and returns the first block
  /// found (nct 14.1, INFERRED order). The first few thousand blocks are searched by reading them; then an index of all block numbers of
  /// the file is built.
  std::optional<Position> find_number(std::uint32_t number, Position from);
  /// Returns the positions where a program O… with this number starts in the file (Grammar::programs_by_label).
  std::vector<Position> programs_numbered(std::uint32_t number);
  /// Returns the position of the first block that contains more than a comment or the sign %.
  Position first_block();
  /// Return the loop whose DO (loop_from) or END (loop_to) is at `position`; nullptr if there is no loop.
  const Loop* loop_from(Position position);
  const Loop* loop_to(Position position);

  /// Returns those of the given lines that exist, in UTF-8, by line number. Reads through the file once.
  std::map<std::uint32_t, std::string> texts_of(const std::set<std::uint32_t>& lines) const;

  /// Returns a line in UTF-8; an empty text if the line does not exist. The first call reads through the file; later calls read a few
  /// lines.
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
  // Number of blocks that are searched without an index; a short file, or a near target, needs no index.
  static constexpr std::size_t max_searched = 4096;
  BlockReader& scanner();
  /// The range of a file from the start of a program to the start of the next program.
  struct Extent {
    Position begin, end;
  };
  Extent extent_of(Position place);
  void find_programs();
  std::optional<Position> in_index(std::uint32_t number, Position from, const Extent& in) const;
  std::optional<Position> search(std::uint32_t number, Position from, const Extent& in);
  std::optional<Position> scan(std::uint32_t number, Position from, Position to);
  void find_loops();
  // Packs the position of a block into one number. A line has at most 64 K blocks, so 16 bits are enough for the block's number in its
  // line.
  static std::uint64_t key_of(Position at) { return at.offset << 16 | at.nth; }
  static std::pair<std::uint64_t, std::uint32_t> place_of(Position at) { return {at.offset, at.nth}; }
  Block* keep(Position at);
  KeptBlock* kept_at(Position place);

  std::string path_;
  std::shared_ptr<ByteSource> source_;
  const Grammar& grammar_;
  BlockReader reader_;
  // a second reader of the file, for searches; the first reader still has the text of the current block
  std::unique_ptr<BlockReader> scanner_;
  Block in_hand_;
  Position elsewhere_;  // position of the next block while `moved_` is true
  bool moved_ = false;  // true: the next block is at `elsewhere_`; false: the next block is at the position of the reader
  // the part of the state that snapshots copy; its member `reader` is unused, because reader_ stores that state itself
  Memory memory_;
  KeptBlock* last_ = nullptr;  // the block kept in memory that was returned last to the caller
  // blocks kept in memory for loops; the key is the position of the block, packed by key_of()
  std::unordered_map<std::uint64_t, std::unique_ptr<KeptBlock>> kept_;
  // Results of searches: {key of the block where the search started; number} → position of the block found.
  std::map<std::pair<std::uint64_t, std::uint32_t>, Position> numbers_;
  std::vector<Loop> loops_;
  std::unordered_map<std::uint64_t, std::size_t> loops_by_begin_, loops_by_end_;
  bool loops_found_ = false;
  const Loop* last_loop_ = nullptr;  // loop whose END was executed last
  std::size_t searched_ = 0;         // number of blocks that were read in searches for block numbers
  std::optional<Position> first_block_;
  std::optional<BlockNumbers> index_;
  struct NumberedProgram {
    Position begin;
    std::uint32_t number = 0;
  };
  std::optional<std::vector<NumberedProgram>> programs_;  // starts of the programs in the file (Grammar::programs_by_label)
  bool index_possible_ = true;
  StopToken stop_;
  static constexpr std::uint32_t marked_line = 256;  // the byte offset is stored for every line with a number 1 + a multiple of this value
  mutable std::vector<std::uint64_t> line_marks_;    // byte offsets of lines 1, 257, …
};

}  // namespace kadr
