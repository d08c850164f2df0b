// Reads and writes .kadr.toml. Used by cli/job/guessed_control and view/opening; tested by tests/guess.py, tests/serve.py.

#include "config/control/remembered_control.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "config/program_names.h"
#include "config/read_file.h"
#include "config/tools/toml_tools.h"
#include "texts/control_file.h"

namespace kadr {
namespace {

namespace fs = std::filesystem;

/// Converts the path of a control file from one relative to the folder of .kadr.toml to one relative to the current folder.
std::string seen_from_here(const fs::path& folder, const std::string& control) {
  if (!control.ends_with(".toml") || fs::path(control).is_absolute()) return control;
  return (folder / control).lexically_normal().string();
}

fs::path program_folder(const std::string& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);
  return error ? fs::path() : whole.lexically_normal().parent_path();
}

}  // namespace

std::optional<RememberedControls::Remembered> RememberedControls::read(const std::string& file) const {
  const auto text = read_file(file, limits::config_file_bytes, door_);
  if (!text) return std::nullopt;
  const auto table = toml_tools::parsed(*text, file);
  Remembered found;
  if (!table) {
    complain_(table.error());
    return found;
  }
  for (const auto& [key, node] : *table) {
    if (key.str() == "control" && node.is_string()) {
      found.control = node.value_or(std::string());
      continue;
    }
    const toml::table* const patterns = key.str() == "control_for" ? node.as_table() : nullptr;
    if (patterns == nullptr) {
      complain_(fmt::format("{}{}", toml_tools::place(file, node), plain_text(texts::control_file::remembered_keys)));
      continue;
    }
    for (const auto& [pattern, control] : *patterns) found.patterns.emplace_back(pattern.str(), control.value_or(std::string()));
  }
  return found;
}

std::string RememberedControls::of(const std::string& program) {
  for (fs::path folder = program_folder(program); !folder.empty(); folder = folder.parent_path()) {
    const auto [at, is_new] = folders_.try_emplace(folder.string());
    if (is_new) at->second = read((folder / remembering_file).string());
    if (const auto& found = at->second) {
      for (const auto& [pattern, control] : found->patterns)
        if (is_like(program, pattern)) return seen_from_here(folder, control);
      return seen_from_here(folder, found->control);
    }
    if (folder == folder.parent_path()) break;
  }
  return {};
}

std::string save_control_choice(const std::string& control, const std::string& program) {
  const fs::path path = program_folder(program) / remembering_file;
  std::string text;
  bool replaced = false;
  const std::string named =
      control.ends_with(".toml") ? fs::absolute(control).lexically_normal().lexically_relative(path.parent_path()).string() : control;
  const std::string row = fmt::format("control = \"{}\"\n", named);
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
  return out && !error ? std::string() : fmt::format("{}: {}", path.string(), errno_message(error ? error.value() : errno));
}

}  // namespace kadr
