#pragma once
// Reads and writes 3MF (3MF Consortium, Core Specification 1.2), an archive that contains a model in XML.

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "stock/mesh/byte_sink.h"
#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// Reads the objects that the file's `build` element assembles, in mm, without support structures.
///   returns  one mesh of all these objects, or an error sentence; rules.memory limits the size of the unpacked file
tl::expected<SolidMesh, std::string> read_3mf(std::string_view bytes, const MeshRules& rules);

/// Writes a 3MF file with one object, in mm. The same mesh always gives the same bytes.
///   returns  an error sentence; empty on success
std::string write_3mf(const Mesh& mesh, const ByteSink& sink);

}  // namespace kadr
