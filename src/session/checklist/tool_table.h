#pragma once
// ToolTable: the tools file that a program is compared with, named by the user or found next to the program.

#include <cstdint>
#include <memory>
#include <string>

#include "base/file_door.h"
#include "config/tool_library.h"

namespace kadr {

struct ToolTable {
  /// named: by the user; own: has the name of the program; common: tools.toml of its folder, which may belong to other work too.
  enum class Kind : std::uint8_t { named, own, common };
  std::string file;  // its name in messages
  ToolLibrary tools;
  Kind kind = Kind::named;
};

/// Looks for NAME.toml or NAME.tbl next to NAME.nc, then for tools.toml. A file that is no tools file is ignored.
///   returns  nullptr if there is none
std::shared_ptr<const ToolTable> tool_table_beside(const std::string& program, const FileDoor* door = nullptr);

/// What the checklist gets besides the run of the program.
struct ChecklistBasis {
  std::shared_ptr<const ToolTable> tools{};
  bool own_tools = true, own_setup = true;  // the tools file, the set-up is used for this program only
};

}  // namespace kadr
