#pragma once
// ToolTable: the tools file with which a program is compared; the user names it, or it is found next to the program.

#include <cstdint>
#include <memory>
#include <string>

#include "base/file_access.h"
#include "config/tools/tool_library.h"

namespace kadr {

struct ToolTable {
  /// named: the user has named the file; own: it has the name of the program; common: tools.toml of the program's folder, which other
  /// programs may use too.
  enum class Kind : std::uint8_t { named, own, common };
  std::string file;  // name of the file in messages
  ToolLibrary tools;
  Kind kind = Kind::named;
};

/// Looks for NAME.toml or NAME.tbl next to NAME.nc, then for tools.toml. Skips a file that is not a tools file.
///   returns  nullptr if no tools file is found
std::shared_ptr<const ToolTable> tool_table_next_to(const std::string& program, const FileAccess* door = nullptr);

/// What the checklist uses in addition to the run of the program.
struct ChecklistBasis {
  std::shared_ptr<const ToolTable> tools{};
  bool own_tools = true, own_setup = true;  // true: the tools file, or the set-up, is used for this program only
};

}  // namespace kadr
