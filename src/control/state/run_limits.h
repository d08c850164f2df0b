#pragma once
// The input of a run besides control and set-up: its program, and the limits that it may not exceed.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/file_access.h"
#include "base/file_id.h"
#include "base/stop_token.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// Limits that stop a runaway program.
struct RunLimits {
  std::uint64_t repeated_blocks = 20'000'000;  // blocks executed again after a jump back
  std::uint32_t restarts = 1000;               // passes of an endless main program (M99, M47)
  bool writes_files = false;                   // FOPEN, POPEN; false: the program is followed as far as possible without writing
  std::string files = ".";                     // folder of the program memory, outside of which nothing is written
  FileSet untouched{};                         // files of the run itself, which no program may write
  StopToken stop{};                            // checked at least once per block
  const FileAccess* door = nullptr;            // opens the files that the program calls and the set-up names; must outlive the run
};

struct Program {
  std::string file;  // name of the program's file, for messages
  std::unique_ptr<ByteSource> source;
  std::optional<Encoding> encoding;
};

}  // namespace kadr
