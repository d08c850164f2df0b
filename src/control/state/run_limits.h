#pragma once
// What a run is made of besides control and set-up: its program, and what it may not exceed.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/file_door.h"
#include "base/file_id.h"
#include "base/stop.h"
#include "lang/block/block_reader.h"

namespace kadr {

/// Limits that stop a runaway program.
struct RunLimits {
  std::uint64_t repeated_blocks = 20'000'000;  // blocks carried out again after a jump back
  std::uint32_t restarts = 1000;               // passes of an endless main program (M99, M47)
  bool writes_files = false;                   // FOPEN, POPEN; false: as far as can be known without writing
  std::string files = ".";                     // folder of the program memory, outside of which nothing is written
  FileSet untouched{};                         // files of the run itself, which no program writes
  StopToken stop{};                            // asked for at least each block
  const FileDoor* door = nullptr;              // opens what the program calls and the set-up names; it outlives the run
};

struct Program {
  std::string file;  // its name, for people
  std::unique_ptr<ByteSource> source;
  std::optional<Encoding> encoding;
};

}  // namespace kadr
