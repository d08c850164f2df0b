#pragma once
// STL, binary and text. Lengths are taken for mm: the format has no unit.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "stock/mesh/byte_sink.h"
#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// Three points a triangle, as they stand; the normals in the file are not asked. The number of triangles in a binary header is not
/// believed: the length of the file is.
///   returns  the triangles, or an error sentence with line or triangle
tl::expected<SolidMesh, std::string> read_stl(std::string_view bytes, const MeshRules& rules);

/// Binary, the same bytes for the same mesh.
///   returns  false: the sink did not take all
bool write_stl(const Mesh& mesh, const ByteSink& sink);

}  // namespace kadr
