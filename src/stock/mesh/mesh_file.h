#pragma once
// Meshes from files: STL or 3MF, whichever it is.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/file_door.h"
#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// By its first bytes, not by its name.
tl::expected<SolidMesh, std::string> read_mesh(std::string_view bytes, const MeshRules& rules);

/// A regular file of at most rules.memory / 2 bytes.
///   returns  notes and error sentences name the file
tl::expected<SolidMesh, std::string> read_mesh_file(const std::string& path, const MeshRules& rules, const FileDoor* door = nullptr);

}  // namespace kadr
