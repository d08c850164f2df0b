// Reads a mesh from an STL or 3MF file. Used by session and cli.

#include "stock/mesh/mesh_file.h"

#include "config/read_file.h"
#include "stock/mesh/stl.h"
#include "stock/mesh/threemf.h"

namespace kadr {

tl::expected<SolidMesh, std::string> read_mesh(std::string_view bytes, const MeshRules& rules) {
  return bytes.starts_with("PK") ? read_3mf(bytes, rules) : read_stl(bytes, rules);
}

tl::expected<SolidMesh, std::string> read_mesh_file(const std::string& path, const MeshRules& rules, const FileAccess* door) {
  const auto bytes = read_file(path, rules.memory / 2, door);
  if (!bytes) return tl::unexpected(bytes.error());
  auto solid = read_mesh(*bytes, rules);
  if (!solid) return tl::unexpected(path + ": " + solid.error());
  for (std::string& note : solid->notes) note.insert(0, path + ": ");
  return solid;
}

}  // namespace kadr
