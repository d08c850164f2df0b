// For cli/guessed_control and cli/job; tests/guess.py.

#include "cli/remembered_control.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/program_files.h"
#include "config/read_file.h"
#include "config/told.h"
#include "config/toml_tools.h"

namespace kadr::cli {
namespace {

namespace fs = std::filesystem;

struct Remembered {
  fs::path folder;
  std::string control;
  std::vector<std::pair<std::string, std::string>> patterns;
};

/// A control file is named as it lies beside the .kadr.toml.
std::string seen_from_here(const Remembered& memory, const std::string& control) {
  if (!control.ends_with(".toml") || fs::path(control).is_absolute()) return control;
  return (memory.folder / control).lexically_normal().string();
}

std::optional<Remembered> read_memory(const fs::path& folder) {
  const std::string file = (folder / remembering_file).string();
  const auto text = read_file(file);
  if (!text) return std::nullopt;
  const auto table = toml_tools::parsed(*text, file);
  Remembered memory{folder, {}, {}};
  if (!table) {
    complain(table.error());
    return memory;
  }
  for (const auto& [key, node] : *table) {
    if (key.str() == "control" && node.is_string()) {
      memory.control = node.value_or(std::string());
      continue;
    }
    const toml::table* const patterns = key.str() == "control_for" ? node.as_table() : nullptr;
    if (patterns == nullptr) {
      complain(fmt::format("{}{}", toml_tools::place(file, node),
                           told("'control', a text, and [control_for] are all that may stand there",
                                "здесь могут стоять только control — строка — и [control_for]")));
      continue;
    }
    for (const auto& [pattern, control] : *patterns) memory.patterns.emplace_back(pattern.str(), control.value_or(std::string()));
  }
  return memory;
}

/// Of the folder itself; each is read once.
const std::optional<Remembered>& memory_of(const fs::path& folder) {
  static std::map<std::string, std::optional<Remembered>> read;
  const auto [at, is_new] = read.try_emplace(folder.string());
  if (is_new) at->second = read_memory(folder);
  return at->second;
}

fs::path program_folder(const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);
  return error ? fs::path() : whole.lexically_normal().parent_path();
}

}  // namespace

std::string remembered_control(const std::string& file) {
  if (file == "-") return {};
  for (fs::path folder = program_folder(file); !folder.empty(); folder = folder.parent_path()) {
    if (const auto& memory = memory_of(folder)) {
      for (const auto& [pattern, control] : memory->patterns)
        if (is_like(file, pattern)) return seen_from_here(*memory, control);
      return seen_from_here(*memory, memory->control);
    }
    if (folder == folder.parent_path()) break;
  }
  return {};
}

bool remember_control(const Options& options, const std::string& file) {
  if (options.control.empty() || file == "-") {
    complain(told("--remember: --control says what", "--remember: что запомнить, скажет --control"));
    return false;
  }
  const fs::path path = program_folder(file) / remembering_file;
  std::string text;
  bool replaced = false;
  std::string control = options.control;
  if (control.ends_with(".toml")) control = fs::absolute(control).lexically_normal().lexically_relative(path.parent_path()).string();
  const std::string row = fmt::format("control = \"{}\"\n", control);
  if (const auto old = read_file(path.string())) {
    for (std::size_t at = 0; at < old->size();) {
      const std::size_t end = std::min(old->find('\n', at), old->size() - 1) + 1;
      const std::string line = old->substr(at, end - at);
      const bool is_row = !replaced && line.starts_with("control") && line.find_first_not_of(" \t", 7) == line.find('=');
      text += is_row ? row : line;
      replaced = replaced || is_row;
      at = end;
    }
  }
  if (!replaced) text = row + text;
  const fs::path written = path.string() + ".new";
  std::ofstream out(written, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  std::error_code error;
  if (out) fs::rename(written, path, error);
  if (!out || error) complain(fmt::format("{}: {}", path.string(), told_errno(error ? error.value() : errno)));
  return out && !error;
}

}  // namespace kadr::cli
