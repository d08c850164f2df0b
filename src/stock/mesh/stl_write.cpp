// Writes binary STL, for the export of the cut part. Used by cli/cut_meshes.

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "stock/mesh/stl.h"

namespace kadr {
namespace {

constexpr std::size_t head_bytes = 80, triangle_bytes = 50;
constexpr std::size_t triangles_at_once = 1024;

void put_number(std::string& out, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) out.push_back(char(value >> (8 * i) & 0xff));
}

void put_float(std::string& out, float value) { put_number(out, std::bit_cast<std::uint32_t>(value)); }

Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 p = b - a, q = c - a;
  const Vec3 n{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  const double size = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  // A triangle without area gets the normal 0, because a reader of the file then computes the normal from the corners.
  return size > 0 ? (1 / size) * n : Vec3{};
}

}  // namespace

bool write_stl(const Mesh& mesh, const ByteSink& sink) {
  std::string out = "binary STL, mm, Kadr";  // this header must not begin with "solid", which readers take as a sign of text STL
  out.resize(head_bytes, ' ');
  put_number(out, std::uint32_t(mesh.triangle_count()));
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::array<Vec3, 3> corner{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    const Vec3 normal = unit_normal(corner[0], corner[1], corner[2]);
    for (const double v : {normal.x, normal.y, normal.z}) put_float(out, float(v));
    for (const Vec3& p : corner)
      for (const double v : {p.x, p.y, p.z}) put_float(out, float(v));
    out.append(2, '\0');
    if (out.size() < triangles_at_once * triangle_bytes) continue;
    if (!sink(out)) return false;
    out.clear();
  }
  return out.empty() || sink(out);
}

}  // namespace kadr
