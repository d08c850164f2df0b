// Finds points that are equal or close to each other, with a hash table of positions. Used by stock/mesh/mesh_repair.

#include "stock/mesh/point_weld.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace kadr {
namespace {

using Key = std::array<std::int64_t, 3>;
constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

std::size_t mixed(const Key& key) {
  std::uint64_t h = 0x9e3779b97f4a7c15u;
  for (const std::int64_t k : key) {
    h ^= std::uint64_t(k);
    h *= 0xff51afd7ed558ccdu;
    h ^= h >> 32;
  }
  return std::size_t(h);
}

/// A hash table: linked lists of point numbers by key. A list may contain the numbers of several keys.
class Buckets {
 public:
  explicit Buckets(std::size_t count) : head_(std::bit_ceil(count + 1), nothing), next_(count, nothing) {}
  void add(const Key& key, std::uint32_t i) {
    std::uint32_t& head = head_[mixed(key) & (head_.size() - 1)];
    next_[i] = head, head = i;
  }
  /// Returns the lowest number with this key for which `fits` is true; `nothing` if there is no such number.
  template <class Fits>
  std::uint32_t lowest(const Key& key, const Fits& fits) const {
    std::uint32_t best = nothing;
    for (std::uint32_t i = head_[mixed(key) & (head_.size() - 1)]; i != nothing; i = next_[i])
      if (i < best && fits(i)) best = i;
    return best;
  }

 private:
  std::vector<std::uint32_t> head_, next_;
};

double squared_distance(const Mesh& mesh, std::size_t a, std::size_t b) {
  const Vec3 d = mesh.point(a) - mesh.point(b);
  return d.x * d.x + d.y * d.y + d.z * d.z;
}

}  // namespace

void weld_equal(Mesh& mesh) {
  const std::size_t count = mesh.point_count();
  std::vector<std::uint32_t> number(count);
  Buckets buckets(count);
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    float* const p = &mesh.points[3 * i];
    Key key;
    for (std::size_t d = 0; d < 3; ++d) {
      p[d] += 0.f;  // turns -0 into 0, so that both have the same key
      key[d] = std::bit_cast<std::int32_t>(p[d]);
    }
    const std::uint32_t same = buckets.lowest(key, [&](std::uint32_t k) {
      const float* const q = &mesh.points[3 * std::size_t(k)];
      return q[0] == p[0] && q[1] == p[1] && q[2] == p[2];
    });
    if (same != nothing) {
      number[i] = same;
      continue;
    }
    for (std::size_t d = 0; d < 3; ++d) mesh.points[3 * std::size_t(kept) + d] = p[d];
    buckets.add(key, kept);
    number[i] = kept++;
  }
  mesh.points.resize(3 * std::size_t(kept));
  for (std::uint32_t& t : mesh.triangles) t = number[t];
}

std::size_t weld_near(Mesh& mesh, const std::vector<bool>& marked, double tolerance) {
  const std::size_t count = mesh.point_count();
  std::vector<std::uint32_t> number(count);
  Buckets buckets(count);
  std::size_t joined = 0;
  const auto key_of = [&](std::size_t i, const Key& step) {
    const Vec3 p = mesh.point(i);
    return Key{std::int64_t(std::floor(p.x / tolerance)) + step[0], std::int64_t(std::floor(p.y / tolerance)) + step[1],
               std::int64_t(std::floor(p.z / tolerance)) + step[2]};
  };
  for (std::size_t i = 0; i < count; ++i) {
    number[i] = std::uint32_t(i);
    if (!marked[i]) continue;
    std::uint32_t best = nothing;
    for (int q = 0; q < 27; ++q) {
      const Key neighbour = key_of(i, {q % 3 - 1, q / 3 % 3 - 1, q / 9 - 1});
      best =
          std::min(best, buckets.lowest(neighbour, [&](std::uint32_t k) { return squared_distance(mesh, i, k) <= tolerance * tolerance; }));
    }
    if (best != nothing) number[i] = best, ++joined;
    else buckets.add(key_of(i, {}), std::uint32_t(i));
  }
  for (std::uint32_t& t : mesh.triangles) t = number[t];
  return joined;
}

void drop_flat(Mesh& mesh, std::vector<std::uint32_t>& numbers) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::uint32_t a = mesh.triangles[3 * t], b = mesh.triangles[3 * t + 1], c = mesh.triangles[3 * t + 2];
    if (a == b || b == c || c == a) continue;
    mesh.triangles[3 * kept] = a, mesh.triangles[3 * kept + 1] = b, mesh.triangles[3 * kept + 2] = c;
    numbers[kept++] = numbers[t];
  }
  mesh.triangles.resize(3 * kept);
  numbers.resize(kept);
}

void drop_unused(Mesh& mesh) {
  std::vector<std::uint32_t> number(mesh.point_count(), nothing);
  for (const std::uint32_t t : mesh.triangles) number[t] = 0;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == nothing) continue;
    for (std::size_t d = 0; d < 3; ++d) mesh.points[3 * std::size_t(kept) + d] = mesh.points[3 * i + d];
    number[i] = kept++;
  }
  mesh.points.resize(3 * std::size_t(kept));
  for (std::uint32_t& t : mesh.triangles) t = number[t];
}

}  // namespace kadr
