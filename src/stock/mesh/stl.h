#pragma once
// Reads and writes STL, binary and text. Lengths are assumed to be in mm, because the format has no unit.

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "stock/mesh/byte_sink.h"
#include "stock/mesh/mesh_repair.h"

namespace kadr {

/// Reads three points per triangle, without merging equal points. Normals in the file are ignored. The number of triangles in a binary
/// file is computed from the file's length, not read from its header.
///   returns  the triangles, or an error sentence that contains the number of the line or triangle
tl::expected<SolidMesh, std::string> read_stl(std::string_view bytes, const MeshRules& rules);

/// Writes binary STL triangle by triangle, of a mesh that is not in memory.
class StlWriter {
 public:
  StlWriter(ByteSink sink, std::uint32_t triangles);
  void add(const Corners& triangle);
  /// To be called after the last triangle.
  ///   returns  false if the sink refused bytes; the file is then incomplete
  bool finish();

 private:
  void flush();

  ByteSink sink_;
  std::string out_;
  bool complete_ = true;
};

/// Writes binary STL. The same mesh always gives the same bytes.
///   returns  false if the sink refused bytes; the file is then incomplete
bool write_stl(const Mesh& mesh, const ByteSink& sink);

}  // namespace kadr
