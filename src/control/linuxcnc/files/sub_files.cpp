// Finds the files of subprograms. Described in sub_files.h.

#include "control/linuxcnc/files/sub_files.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "control/flow/flow.h"
#include "control/linuxcnc/linuxcnc.h"

namespace kadr::linuxcnc {
namespace {

namespace fs = std::filesystem;

/// Returns true if the path, with symbolic links followed, is in the folder or in a folder below it.
bool is_within(const fs::path& path, const fs::path& folder) {
  std::error_code error, other;
  const fs::path real = fs::canonical(path, error);
  const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, other);
  return !error && !other && std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
}

}  // namespace

std::optional<std::uint16_t> file_of_label(Flow& flow, const LinuxCnc& control, const std::string& label) {
  if (label.find_first_of("/\\") != std::string::npos || label.starts_with('.')) return std::nullopt;
  const fs::path memory = flow.limits().files;
  std::vector<fs::path> folders = {fs::path(flow.main_file()).parent_path(), memory};
  const std::size_t own = folders.size();
  for (const std::string& folder : control.machine.subprogram_folders) folders.push_back(memory / folder);
  for (std::size_t i = 0; i < folders.size(); ++i) {
    std::error_code error;
    const fs::path path = folders[i] / (label + ".ngc");
    if (!fs::is_regular_file(path, error) || !is_within(path, i < own ? folders[i] : memory)) continue;
    if (const auto reader = flow.open_program(path.string())) return reader;
  }
  return std::nullopt;
}

}  // namespace kadr::linuxcnc
