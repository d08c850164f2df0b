#pragma once
// BlockReader: reads the blocks of a program from its lines. This class is the entrance to the room `lang`.

#include <memory>
#include <optional>
#include <string>

#include "lang/block/block.h"
#include "lang/block/plain_block.h"
#include "lang/block/program_frame.h"
#include "lang/text/line_reader.h"
#include "lang/text/tape_orientation.h"

namespace kadr {

class BlockReader {
  static constexpr std::uint64_t no_mark = ~std::uint64_t{0};

 public:
  /// `encoding`: the encoding that the user gives. If it is nullopt, the encoding is guessed when a line first has to be decoded.
  BlockReader(std::shared_ptr<ByteSource> source, const Grammar& grammar, std::optional<Encoding> encoding);

  enum class Got : std::uint8_t { block, end };

  /// Reads the next block that is not empty. On an alarm, `block` has its text, its location and, if this was read, its number. The next
  /// call continues after the faulty block.
  Result<Got> next(Block& block);
  /// Continues with the block at `position`.
  void seek(Position position);
  /// Position of the next block.
  Position position() const { return position_; }
  /// Returns the text of the last block in UTF-8, whatever the encoding of the file. `place` is converted to the location in the returned
  /// text.
  std::string shown(std::string_view text, Span& place) const;
  /// The data that the reader has collected from the lines read so far. With these data and the position, a reader can continue.
  struct Memory {
    std::optional<Encoding> encoding;
    bool guessed = false;
    std::uint64_t first_mark = no_mark;  // offset of the first line with a block that ends with ПС or LF; no_mark: no such line yet
    bool orientation_reported = false;
    bool expects_high_bytes = false;  // an earlier line had bytes above 127, so the next lines probably have some too
    friend bool operator==(const Memory&, const Memory&) = default;
  };
  const Memory& memory() const { return memory_; }
  void resume_from(const Memory& memory) { memory_ = memory; }
  Encoding encoding() const { return memory_.encoding.value_or(Encoding::utf8); }
  bool encoding_was_guessed() const { return memory_.guessed; }
  std::uint64_t size() const { return lines_.size(); }
  std::uint64_t offset() const { return lines_.offset(); }

 private:
  Result<Got> reversed_tape(Block& block);
  Status begin_line(Block& block, std::uint32_t nth);
  Status lex_line(Block& block);
  Status decode_line();
  bool is_sign_of_end() const;
  Status join_comment(Block& block, std::size_t open);
  Result<bool> join_line(Block& block);

  LineReader lines_;
  const Grammar& grammar_;
  PlainBlocks plain_;
  Memory memory_;
  Line line_;
  std::string decoded_;    // current line in UTF-8, if the file has another encoding
  std::string joined_;     // the lines of a comment that spans several lines, joined (nct 14.3)
  std::string_view text_;  // text of the current line
  std::size_t rest_ = 0;   // offset in text_ at which the next block starts
  bool in_line_ = false;
  bool is_text_ = false;  // text_ is valid UTF-8, so it need not be decoded
  TapeOrientation orientation_ = TapeOrientation::right;
  ProgramFrame frame_;  // start and end of the program by the signs %, on controls that use the signs in this way
  Position position_;
};

}  // namespace kadr
