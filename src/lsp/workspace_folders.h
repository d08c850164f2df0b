#pragma once
// The folders that the editor shows (LSP 3.17, "WorkspaceFolder"), in which programs call each other too.

#include <cstddef>
#include <filesystem>
#include <vector>

#include "lsp/lsp_json.h"

namespace kadr {

/// Greatest number of folders, with their subfolders; further ones are not looked at.
inline constexpr std::size_t max_workspace_folders = 64;

/// Returns the folders of a list of WorkspaceFolder that are in the file system.
///   throws  LspFault if the JSON value is not a list
std::vector<std::filesystem::path> folders_in(const LspJson& list);
/// Returns the folders that the request `initialize` names: `workspaceFolders`, or the older `rootUri`.
std::vector<std::filesystem::path> workspace_folders_in(const LspJson& params);
/// Returns the folders and their subfolders, those near the top first, without hidden ones and links.
std::vector<std::filesystem::path> with_subfolders(const std::vector<std::filesystem::path>& folders);

}  // namespace kadr
