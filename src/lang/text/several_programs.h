#pragma once
// A tape with several programs: where each starts, and which sections of subprograms belong to it (spec/gost 1, 2С42 6.2, 6.3.5).

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lang/block/block_reader.h"

namespace kadr {

/// A range of bytes in the file; both ends are starts of lines.
struct ByteRange {
  std::uint64_t begin = 0, end = 0;
};

/// A program: from its sign % to the next one, or to a section of subprograms.
struct TapeProgram {
  ByteRange bytes;
  std::uint32_t number = 0;  // after %, or of O in the next block; 0: none
};

/// The blocks of one subprogram in a section (2С42: N02001 …).
struct TapeSubprogram {
  ByteRange bytes;
  std::uint32_t number = 0;
};

struct TapeContents {
  std::vector<TapeProgram> programs;
  std::vector<TapeSubprogram> subprograms;
};

/// Counts the signs % of a file, whatever their meaning: with fewer than two it has only one program and need not be analysed.
std::size_t count_program_signs(ByteSource& source, std::optional<Encoding> encoding);

/// Analyses a whole file, up to some thousand programs. A sign % without a block after it is not a program. Unreadable blocks are skipped.
TapeContents contents_of(const std::shared_ptr<ByteSource>& source, const Grammar& grammar, std::optional<Encoding> encoding);

/// Returns the program with this number; if no program has a number, the one at this place, counted from 1 (our choice).
std::optional<std::size_t> program_numbered(const TapeContents& contents, std::uint32_t number);

/// Returns the file reduced to one of its programs: the others are blanked, and so are the subprograms that would not be in the memory
/// of a control that reads the tape: of two with the same number the last one before the program is used, else the first after it
/// (INFERRED). All places stay the same.
std::unique_ptr<ByteSource> only_program(std::shared_ptr<ByteSource> source, const TapeContents& contents, std::size_t index,
                                         std::optional<Encoding> encoding);

/// A file that others read too, unchanged.
std::unique_ptr<ByteSource> whole_file(std::shared_ptr<ByteSource> source);

}  // namespace kadr
