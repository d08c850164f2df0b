#pragma once
// A tape with several programs: where each begins, what of the sections of subprograms belongs to it (spec/gost 1, 2С42 6.2, 6.3.5).

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lang/block/block_reader.h"

namespace kadr {

/// Bytes of the file, from a beginning of a line to another.
struct ByteRange {
  std::uint64_t begin = 0, end = 0;
};

/// From its sign % to the next one, or to a section of subprograms.
struct TapeProgram {
  ByteRange bytes;
  std::uint32_t number = 0;  // after %, or of O in the block after; 0: none
};

/// The blocks of one subprogram of a section (2С42: N02001 …).
struct TapeSubprogram {
  ByteRange bytes;
  std::uint32_t number = 0;
};

struct TapeContents {
  std::vector<TapeProgram> programs;
  std::vector<TapeSubprogram> subprograms;
};

/// The signs % of a file, whatever they mean there: with fewer than two it holds one program, and need not be read for more.
std::size_t count_program_signs(ByteSource& source, std::optional<Encoding> encoding);

/// All of a file, at most some thousand programs; a sign % without a block after it is none. What cannot be read is passed over.
TapeContents contents_of(const std::shared_ptr<ByteSource>& source, const Grammar& grammar, std::optional<Encoding> encoding);

/// The program of that number; where none has a number, the one in that place, from 1 (ours).
std::optional<std::size_t> program_numbered(const TapeContents& contents, std::uint32_t number);

/// The file with one of its programs: the others are blank, as are the subprograms that a reader of the tape would not have in memory:
/// of two with the same number the last one before the program counts, else the first one after it (INFERRED). Places stay.
std::unique_ptr<ByteSource> only_program(std::shared_ptr<ByteSource> source, const TapeContents& contents, std::size_t index,
                                         std::optional<Encoding> encoding);

/// A file that others read too, as it is.
std::unique_ptr<ByteSource> whole_file(std::shared_ptr<ByteSource> source);

}  // namespace kadr
