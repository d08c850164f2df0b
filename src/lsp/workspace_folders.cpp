// The folders that the editor shows. Used by lsp/language_server; tested by tests/lsp.py.

#include "lsp/workspace_folders.h"

#include <algorithm>

#include "config/texts.h"
#include "texts/lsp.h"

namespace kadr {

namespace fs = std::filesystem;

std::vector<fs::path> folders_in(const LspJson& list) {
  if (!list.is_array()) throw LspFault{LspFault::invalid_params, translated(texts::lsp::wrong_member, "workspaceFolders")};
  std::vector<fs::path> folders;
  for (const LspJson& one : list) {
    if (!one.is_object() || !one.contains("uri") || !one["uri"].is_string() || folders.size() == max_workspace_folders) continue;
    // The path of an entry of a folder has no slash at its end.
    if (const auto path = path_of_uri(one["uri"].get<std::string>()))
      folders.push_back(fs::path(*path).has_filename() ? fs::path(*path) : fs::path(*path).parent_path());
  }
  return folders;
}

std::vector<fs::path> workspace_folders_in(const LspJson& params) {
  if (const auto list = params.find("workspaceFolders"); list != params.end() && list->is_array()) return folders_in(*list);
  if (const auto root = params.find("rootUri"); root != params.end() && root->is_string())
    return folders_in(LspJson::array({{{"uri", *root}}}));
  return {};
}

std::vector<fs::path> with_subfolders(const std::vector<fs::path>& folders) {
  constexpr std::size_t max_entries = 50'000;  // of all folders together
  std::vector<fs::path> all;
  const auto add = [&](const fs::path& folder) {
    if (all.size() < max_workspace_folders && std::find(all.begin(), all.end(), folder) == all.end()) all.push_back(folder);
  };
  for (const fs::path& folder : folders) add(folder);
  std::size_t entries = 0;
  for (std::size_t i = 0; i < all.size() && all.size() < max_workspace_folders; ++i) {
    std::vector<fs::path> below;
    std::error_code error;
    fs::directory_iterator entry(all[i], fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::directory_iterator() && entries < max_entries; entry.increment(error), ++entries) {
      const std::string name = entry->path().filename().string();
      std::error_code none;
      if (name.starts_with('.') || name == "node_modules" || entry->is_symlink(none) || !entry->is_directory(none)) continue;
      below.push_back(entry->path());
    }
    std::sort(below.begin(), below.end());  // the order of a folder's entries depends on the file system
    for (const fs::path& one : below) add(one);
  }
  return all;
}

}  // namespace kadr
