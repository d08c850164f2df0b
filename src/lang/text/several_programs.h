#pragma once
// Analyses a tape with several programs: where each program starts, and which sections of subprograms belong to it (spec/gost 1, 2С42 6.2,
// 6.3.5).

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lang/block/block_reader.h"

namespace kadr {

/// A range of bytes in the file. It starts and ends at the starts of lines.
struct ByteRange {
  std::uint64_t begin = 0, end = 0;
};

/// A program on the tape. It extends from its sign % to the next sign %, or to a section of subprograms.
struct TapeProgram {
  ByteRange bytes;
  std::uint32_t number = 0;  // number of the program, written after % or as O in the next block; 0: the program has no number
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

/// Counts the signs % of a file, whatever their meaning. A file with fewer than two signs has only one program and need not be analysed.
std::size_t count_program_signs(ByteSource& source, std::optional<Encoding> encoding);

/// Analyses a whole file, up to some thousand programs. A sign % without a block after it starts no program. Unreadable blocks are
/// skipped.
TapeContents contents_of(const std::shared_ptr<ByteSource>& source, const Grammar& grammar, std::optional<Encoding> encoding);

/// Returns the index of the program with this number. If no program has a number, programs are counted from 1 (our choice).
std::optional<std::size_t> program_numbered(const TapeContents& contents, std::uint32_t number);

/// Returns the file reduced to one of its programs. The rest of the text is replaced by blanks, so byte offsets and line numbers are the
/// same as in the file. The subprograms remain that would be in the memory of a control that reads the tape. INFERRED: of two subprograms
/// with the same number the last one before the program remains; if there is none, the first one after it.
std::unique_ptr<ByteSource> only_program(std::shared_ptr<ByteSource> source, const TapeContents& contents, std::size_t index,
                                         std::optional<Encoding> encoding);

/// Returns a source that reads the whole file. Other readers may read the file at the same time.
std::unique_ptr<ByteSource> whole_file(std::shared_ptr<ByteSource> source);

}  // namespace kadr
