// Finds tools files next to programs. This file is used by cli/check and view/opening, and tested by tests/checklist.py.

#include "session/checklist/tool_table.h"

#include <filesystem>

#include "config/read_file.h"

namespace kadr {
namespace {

// greatest size, bytes, of a tools file that is read although the user has not named it
constexpr std::size_t longest = std::size_t{1} << 20;

}  // namespace

std::shared_ptr<const ToolTable> tool_table_next_to(const std::string& program, const FileAccess* door) {
  namespace fs = std::filesystem;
  const fs::path path(program);
  if (program == "-" || path.extension() == ".toml") return nullptr;
  const std::string stem = path.stem().string();
  for (const auto& [name, kind] : {std::pair(stem + ".toml", ToolTable::Kind::own), std::pair(stem + ".tbl", ToolTable::Kind::own),
                                   std::pair(std::string("tools.toml"), ToolTable::Kind::common)}) {
    const std::string file = (path.parent_path() / name).string();
    std::error_code none;
    if (door == nullptr && !fs::is_regular_file(file, none)) continue;
    if (const auto text = read_file(file, longest, door); !text) continue;
    auto tools = load_tools(file, door);
    if (tools && !tools->tools.empty()) return std::make_shared<const ToolTable>(ToolTable{name, std::move(*tools), kind});
  }
  return nullptr;
}

}  // namespace kadr
