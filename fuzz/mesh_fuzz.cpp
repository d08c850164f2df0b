// Fuzz target for the mesh readers. The input is an STL or 3MF file of any bytes. A mesh that is accepted must be closed and of limited
// size, must be usable as a blank, and can be written again.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "require.h"
#include "stock/blank/mesh_blank.h"
#include "stock/mesh/mesh_edges.h"
#include "stock/mesh/mesh_file.h"
#include "stock/mesh/stl.h"

namespace {

constexpr std::size_t memory = std::size_t(1) << 24;
constexpr std::size_t few = 3000;  // number of triangles up to which the further checks are done: more only cost time

void hold(const kadr::Mesh& mesh, const kadr::MeshRules& rules) {
  using kadr::fuzz::require;
  require(mesh.triangle_count() > 0 && mesh.triangle_count() <= rules.memory / kadr::solid_bytes(1),
          "a mesh has triangles, and not too many");
  for (const std::uint32_t t : mesh.triangles) require(t < mesh.point_count(), "a corner is a point");
  for (const float p : mesh.points) require(std::fabs(double(p)) <= rules.reach, "points are within reach");
  require(kadr::edges_of(mesh).open == 0, "a solid is closed");
  require(kadr::volume_of(mesh) > 0, "a solid encloses something");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using kadr::fuzz::require;
  kadr::MeshRules rules;
  rules.memory = memory;
  const auto solid = kadr::read_mesh({reinterpret_cast<const char*>(data), size}, rules);
  if (!solid) {
    require(!solid.error().empty() && kadr::fuzz::is_utf8(solid.error()), "a refusal says why");
    return 0;
  }
  hold(solid->mesh, rules);
  for (const std::string& note : solid->notes) require(kadr::fuzz::is_utf8(note), "a note is text");
  if (solid->mesh.triangle_count() > few) return 0;
  const auto blank = kadr::mesh_blank(solid->mesh);
  const kadr::Box3 box = blank->box();
  for (int family = 0; family < 3; ++family) {
    std::vector<kadr::LineRange> ranges;
    const int u = (family + 1) % 3, v = (family + 2) % 3;
    blank->cross(family, 0.5 * (kadr::along(box.least, u) + kadr::along(box.most, u)),
                 0.5 * (kadr::along(box.least, v) + kadr::along(box.most, v)), ranges);
    double before = kadr::along(box.least, family);
    for (const kadr::LineRange& r : ranges) {
      require(r.from >= before && r.to > r.from && r.to <= kadr::along(box.most, family),
              "stretches of a line follow each other within the box");
      before = r.to;
    }
  }
  std::string stl;
  require(kadr::write_stl(solid->mesh,
                          [&](std::string_view bytes) {
                            stl += bytes;
                            return true;
                          }),
          "a mesh can be written");
  require(stl.size() == 84 + 50 * solid->mesh.triangle_count(), "an STL has all triangles");
  return 0;
}
