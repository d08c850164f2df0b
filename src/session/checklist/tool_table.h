#pragma once
// The tools file that a program is held against: named by the user, or beside the program.

#include <cstdint>
#include <memory>
#include <string>

#include "base/file_door.h"
#include "config/tool_library.h"

namespace kadr {

struct ToolTable {
  /// named: by the user; own: called as the program; common: tools.toml of its folder, which may be of other work too.
  enum class Kind : std::uint8_t { named, own, common };
  std::string file;  // told
  ToolLibrary tools;
  Kind kind = Kind::named;
};

/// NAME.toml or NAME.tbl beside NAME.nc, else tools.toml; what is no tools file counts as none.
///   returns  nullptr: there is none
std::shared_ptr<const ToolTable> tool_table_beside(const std::string& program, const FileDoor* door = nullptr);

/// What the checklist knows of a program besides its run.
struct ChecklistBasis {
  std::shared_ptr<const ToolTable> tools{};
  bool own_tools = true, own_setup = true;  // nothing else is checked with the tools file, with the set-up
};

}  // namespace kadr
