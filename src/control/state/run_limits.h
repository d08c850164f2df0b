#pragma once
// The input of a run other than control and set-up: the program, and the limits that the run may not exceed.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/file_access.h"
#include "base/file_id.h"
#include "base/stop_token.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// The limits that stop a program which never ends, and what a program may do with files.
struct RunLimits {
  std::uint64_t repeated_blocks = 20'000'000;  // greatest number of blocks that are executed again after jumps back
  std::uint32_t restarts = 1000;               // greatest number of passes of a main program that starts again (M99, M47)
  // true: the program may write files (FOPEN, POPEN); false: the program runs without writing, as far as possible
  bool writes_files = false;
  std::string files = ".";           // folder of the program memory, outside of which nothing is written
  FileSet untouched{};               // files that belong to the run itself, such as its trace and set-up; no program may write them
  StopToken stop{};                  // flag by which the caller stops the run; the run polls it at least once per block
  const FileAccess* door = nullptr;  // object that opens the files that the program calls and the set-up names; must outlive the run
};

struct Program {
  std::string file;  // name of the program's file as alarms and other messages give it
  std::unique_ptr<ByteSource> source;
  std::optional<Encoding> encoding;
};

}  // namespace kadr
