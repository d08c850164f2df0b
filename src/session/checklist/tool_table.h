#pragma once
// ToolTable: the tools file with which a program is compared. Either the user names the file, or it is found next to the program.

#include <cstdint>
#include <memory>
#include <string>

#include "base/file_access.h"
#include "config/tools/tool_library.h"

namespace kadr {

struct ToolTable {
  /// The origin of the tools file. named: the user has named the file; own: the file has the name of the program; common: the file is
  /// tools.toml in the program's folder, which other programs may use too.
  enum class Kind : std::uint8_t { named, own, common };
  std::string file;  // name of the tools file, as messages show it
  ToolLibrary tools;
  Kind kind = Kind::named;
};

/// Reads the tools file next to the program NAME.nc: NAME.toml or NAME.tbl, otherwise tools.toml. A file with other contents is skipped.
///   returns  nullptr if no tools file is found
std::shared_ptr<const ToolTable> tool_table_next_to(const std::string& program, const FileAccess* door = nullptr);

/// What the checklist uses in addition to the run of the program.
struct ChecklistBasis {
  std::shared_ptr<const ToolTable> tools{};
  // Two flags. own_tools: only this program uses the tools file; own_setup: only this program uses the set-up.
  bool own_tools = true, own_setup = true;
};

}  // namespace kadr
