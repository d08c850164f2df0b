#pragma once
// The O lines of the files of a run, found by one reading of each, and the labels that are in use (spec/linuxcnc 6).

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lang/block/block.h"
#include "lang/text/line_reader.h"

namespace kadr {
class Interpreter;
class ProgramFile;
}  // namespace kadr

namespace kadr::linuxcnc {

/// One O line.
struct OLine {
  Position at, behind;     // the line; the next one
  std::string label;       // as labels are compared; empty: `expression` says it when it is asked for
  std::string expression;  // of O[…], O#…
  OWord word = OWord::label;
  std::int32_t sub = -1;   // the line of the subprogram that it stands in, -1: none
  std::int32_t next = -1;  // the next line of the same label in the same subprogram, -1: none
};

/// A number as a label is compared.
std::string label_of_number(double number);
/// The label of a block that is an O line, where its text says it; else "".
std::string written_label(const Block& block);

/// Those of one file.
struct OFile {
  std::vector<OLine> lines;
  std::unordered_map<std::uint64_t, std::int32_t> by_offset;
  bool all = true;  // false: it has more than are kept
};

/// A label in use: what it stands for, and how far that is.
struct Mark {
  OWord word = OWord::label;
  Position at;  // its line
  std::uint16_t reader = 0;
  double left = 0;     // passes of a repetition that are to come
  bool taken = false;  // a branch of the `if` has been
};

struct FlowTable {
  static constexpr std::size_t most_lines = 200'000;  // of a file

  /// The O lines of the file being read; read when they are first asked for.
  const OFile& of(Interpreter& m);
  const OFile& of(Interpreter& m, std::uint16_t reader);

  std::map<std::uint16_t, OFile> files;
  // ---- what a snapshot holds
  struct Memory {
    std::map<std::pair<std::string, std::string>, Mark> marks;         // {subprogram, label}
    std::map<std::string, std::pair<std::uint16_t, Position>> passed;  // subprograms by label: file, line
    std::string defining;                                              // label of the definition being passed over
    std::string refused;                                               // what is said at the line that has been jumped to
    std::vector<std::string> calls;                                    // subprograms that are open
    std::vector<bool> by_m98;                                          // … and how each was called
  } memory;
};

}  // namespace kadr::linuxcnc
