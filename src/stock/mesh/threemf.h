#pragma once
// 3MF (3MF Consortium, Core Specification 1.2): an archive with a model in XML.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "stock/mesh/byte_sink.h"
#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// Reads the bodies that the file's `build` assembles, in mm, without support structures.
///   returns  one mesh, or an error sentence; rules.memory limits the unpacked size
tl::expected<SolidMesh, std::string> read_3mf(std::string_view bytes, const MeshRules& rules);

/// Writes one object, in mm. The same mesh gives the same bytes.
///   returns  an error sentence; empty on success
std::string write_3mf(const Mesh& mesh, const ByteSink& sink);

}  // namespace kadr
