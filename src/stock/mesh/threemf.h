#pragma once
// 3MF (3MF Consortium, Core Specification 1.2): an archive with a model in XML.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "stock/mesh/byte_sink.h"
#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// The bodies that the file's `build` puts together, in mm; support structures are left out.
///   returns  one mesh, or an error sentence; what the file unpacks to is bounded by rules.memory
tl::expected<SolidMesh, std::string> read_3mf(std::string_view bytes, const MeshRules& rules);

/// One object, in mm. The same bytes for the same mesh.
///   returns  an error sentence; empty: all was taken
std::string write_3mf(const Mesh& mesh, const ByteSink& sink);

}  // namespace kadr
