#pragma once
// One file of the program memory: reader, blocks kept for loops, places of numbers and loops (spec/nct/14, 23 23.2.8, 23.2.11).

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/stop.h"
#include "control/flow/block_numbers.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// A block kept as it was read, so that a loop compiles it once.
struct KeptBlock {
  Block block;
  std::string text;
  Position next;
  KeptBlock* following = nullptr;  // the kept block at `next`
  KeptBlock* jumped = nullptr;     // the one that a jump went to last
  std::uint64_t jumped_to = 0;     // its key
};

/// DO … END of a file, paired as they stand in the text.
struct Loop {
  Position begin;   // the block with DO
  Position body;    // after it
  Position end;     // the block with END
  Position behind;  // after that
  AlarmId fault = no_alarm;
  std::uint8_t number = 0;  // 0: WHILE whose DO is missing
  bool damaged = false;     // one of the two blocks cannot be read: END does nothing
};

class ProgramFile {
 public:
  ProgramFile(std::string path, std::shared_ptr<ByteSource> source, const Grammar& grammar, std::optional<Encoding> encoding,
              StopToken stop = {});

  /// The next block; `block` points at it until the next call. Where blocks are kept it may be one read before.
  Result<BlockReader::Got> next(Block*& block);
  void seek(Position position) {
    elsewhere_ = position;
    moved_ = true;
  }
  Position position() const { return moved_ ? elsewhere_ : reader_.position(); }
  /// The warnings of a block that is kept are told once.
  void note_told(const Block& block) {
    if (block.kept) memory_.told.insert(place_of(block.position));
  }
  /// What the run so far has left in the file's reading; with the position all that a run goes on from.
  struct Memory {
    BlockReader::Memory reader;
    bool keeps = false;
    std::set<std::pair<std::uint64_t, std::uint32_t>> told{};  // places of kept blocks whose warnings have been told
  };
  Memory memory() const {
    Memory now = memory_;
    now.reader = reader_.memory();
    return now;
  }
  void remember(const Memory& memory) {
    memory_ = memory;
    reader_.remember(memory.reader);
  }
  /// From now on blocks are kept: they will be read again.
  void keep_blocks() { memory_.keeps = true; }

  /// First block numbered `number` from `from` to the end, then from the beginning (nct 14.1, INFERRED order). Reads on for the
  /// first few thousand blocks; after that the file is read once for all its numbers.
  std::optional<Position> find_number(std::uint32_t number, Position from);
  /// Where O… of that number begins a program of the file (Grammar::programs_by_label).
  std::vector<Position> programs_numbered(std::uint32_t number);
  /// The first block with anything but a comment or the sign %.
  Position first_block();
  /// The loop whose DO, or END, stands at `position`.
  const Loop* loop_from(Position position);
  const Loop* loop_to(Position position);

  /// Lines as UTF-8 by their numbers; those that are not there are missing. One pass through the file.
  std::map<std::uint32_t, std::string> texts_of(const std::set<std::uint32_t>& lines) const;

  /// One line as UTF-8; empty if it is not there. The first call goes through the file, the others read some lines.
  std::string text_of(std::uint32_t line) const;

  const std::string& path() const { return path_; }
  const BlockReader& reader() const { return reader_; }
  BlockReader& reader() { return reader_; }
  const std::shared_ptr<ByteSource>& source() const { return source_; }
  std::string shown(std::string_view text, Span& place) const { return reader_.shown(text, place); }
  const Grammar& grammar() const { return grammar_; }

 private:
  static constexpr std::size_t most_kept = 4096;
  static constexpr std::size_t most_loops = 100'000;
  static constexpr std::size_t most_searched = 4096;  // blocks: a short file, or a jump to a near block, needs no index
  BlockReader& scanner();
  /// From a program's beginning to that of the next one.
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
  std::unique_ptr<BlockReader> scanner_;  // reads in other places: the current block keeps its text
  Block in_hand_;
  Position elsewhere_;                                                   // where the next block begins …
  bool moved_ = false;                                                   // … if that is not where the reader is
  Memory memory_;                                                        // but for the reader's
  KeptBlock* last_ = nullptr;                                            // handed out last
  std::unordered_map<std::uint64_t, std::unique_ptr<KeptBlock>> kept_;   // by key
  std::map<std::pair<std::uint64_t, std::uint32_t>, Position> numbers_;  // {from: offset, block of the line; number} → place
  std::vector<Loop> loops_;
  std::unordered_map<std::uint64_t, std::size_t> loops_by_begin_, loops_by_end_;
  bool loops_found_ = false;
  const Loop* last_loop_ = nullptr;  // whose END was met last
  std::size_t searched_ = 0;         // blocks read for numbers
  std::optional<Position> first_block_;
  std::optional<BlockNumbers> index_;
  struct NumberedProgram {
    Position begin;
    std::uint32_t number = 0;
  };
  std::optional<std::vector<NumberedProgram>> programs_;  // where those of the file begin (Grammar::programs_by_label)
  bool index_possible_ = true;
  StopToken stop_;
  static constexpr std::uint32_t marked_line = 256;  // every so many lines one of them
  mutable std::vector<std::uint64_t> line_marks_;    // where they begin: lines 1, 257, …
};

}  // namespace kadr
