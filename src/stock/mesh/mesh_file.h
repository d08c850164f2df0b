#pragma once
// Reads a mesh from a file in STL or 3MF format.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/file_access.h"
#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// Reads a mesh from the content of a file. The first bytes decide which format is read, not the file name.
tl::expected<SolidMesh, std::string> read_mesh(std::string_view bytes, const MeshRules& rules);

/// Reads a regular file of at most rules.memory / 2 bytes.
///   returns  a closed mesh, or a sentence that describes the error; notes and errors contain the file name
tl::expected<SolidMesh, std::string> read_mesh_file(const std::string& path, const MeshRules& rules, const FileAccess* door = nullptr);

}  // namespace kadr
