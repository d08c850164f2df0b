#pragma once
// Reads a mesh from a file, STL or 3MF.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/file_door.h"
#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// Detects the format by the first bytes, not by the file name.
tl::expected<SolidMesh, std::string> read_mesh(std::string_view bytes, const MeshRules& rules);

/// Reads a regular file of at most rules.memory / 2 bytes.
///   returns  a solid, or an error sentence; notes and error name the file
tl::expected<SolidMesh, std::string> read_mesh_file(const std::string& path, const MeshRules& rules, const FileDoor* door = nullptr);

}  // namespace kadr
