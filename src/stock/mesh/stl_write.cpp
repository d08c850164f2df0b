// Writes binary STL, for the export of the cut part. Used by cli/cut_meshes.

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

StlWriter::StlWriter(ByteSink sink, std::uint32_t triangles) : sink_(std::move(sink)) {
  out_ = "binary STL, mm, Kadr";  // this header must not begin with "solid", which readers take as a sign of text STL
  out_.resize(head_bytes, ' ');
  put_number(out_, triangles);
}

void StlWriter::add(const Corners& corners) {
  const Vec3 normal = unit_normal(corners[0], corners[1], corners[2]);
  for (const double v : {normal.x, normal.y, normal.z}) put_float(out_, float(v));
  for (const Vec3& p : corners)
    for (const double v : {p.x, p.y, p.z}) put_float(out_, float(v));
  out_.append(2, '\0');
  if (out_.size() >= triangles_at_once * triangle_bytes) flush();
}

void StlWriter::flush() {
  complete_ = complete_ && (out_.empty() || sink_(out_));
  out_.clear();
}

bool StlWriter::finish() {
  flush();
  return complete_;
}

bool write_stl(const Mesh& mesh, const ByteSink& sink) {
  StlWriter writer(sink, std::uint32_t(mesh.triangle_count()));
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) writer.add(mesh.corners(t));
  return writer.finish();
}

}  // namespace kadr
