// Writes binary PLY, which shows the deviation of the cut part from the wanted part. Used by cli/cut_meshes.

#include <bit>
#include <string>

#include "stock/mesh/ply.h"

namespace kadr {
namespace {

constexpr std::size_t ply_bytes_at_once = 1 << 16;

void put_bytes(std::string& out, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) out.push_back(char(value >> (8 * i) & 0xff));
}

std::string ply_head(const Mesh& mesh) {
  return "ply\nformat binary_little_endian 1.0\ncomment Kadr; lengths in mm; deviation from the part that is wanted, above 0: left "
         "on\nelement vertex " +
         std::to_string(mesh.point_count()) +
         "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
         "property float deviation\nelement face " +
         std::to_string(mesh.triangle_count()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

}  // namespace

bool write_ply(const Mesh& mesh, const std::vector<float>& deviation, const ColourOf& colour, const ByteSink& sink) {
  std::string out = ply_head(mesh);
  const auto pass_on = [&](std::size_t least) {
    if (out.size() < least) return true;
    const bool taken = sink(out);
    out.clear();
    return taken;
  };
  for (std::size_t i = 0; i < mesh.point_count(); ++i) {
    for (std::size_t d = 0; d < 3; ++d) put_bytes(out, std::bit_cast<std::uint32_t>(mesh.points[3 * i + d]), 4);
    const std::uint32_t rgb = colour(deviation[i]);
    for (const int shift : {16, 8, 0}) put_bytes(out, rgb >> shift & 0xff, 1);
    put_bytes(out, std::bit_cast<std::uint32_t>(deviation[i]), 4);
    if (!pass_on(ply_bytes_at_once)) return false;
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    put_bytes(out, 3, 1);
    for (std::size_t k = 0; k < 3; ++k) put_bytes(out, mesh.triangles[3 * t + k], 4);
    if (!pass_on(ply_bytes_at_once)) return false;
  }
  return pass_on(1);
}

}  // namespace kadr
