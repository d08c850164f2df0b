// Intersects lattice lines with a closed mesh. Used by stock/stock.

#include "stock/blank/mesh_blank.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "stock/mesh/mesh_index.h"
#include "stock/mesh/mesh_within.h"

namespace kadr {
namespace {

// Limit in mm: intersections of a line with the mesh that are closer together count as one, because positions are rounded to single
// precision.
constexpr double same_hit = 1e-3;
constexpr int lines_to_overlap = 128;

class MeshBlank : public Blank {
 public:
  explicit MeshBlank(Mesh mesh) : mesh_(std::move(mesh)), box_(box_of(mesh_)), volume_(volume_of(mesh_)) {}
  MeshBlank(const MeshBlank&) = delete;
  MeshBlank& operator=(const MeshBlank&) = delete;

  Box3 box() const override { return box_; }
  /// The volume formula of a mesh would count a region inside two overlapping shells twice. So if shells overlap, the volume is measured by
  /// intervals of lines instead.
  double volume() const override { return overlaps() ? Blank::volume_within(box_) : volume_; }
  const Mesh* mesh() const override { return &mesh_; }
  double volume_within(const Box3& box) const override { return overlaps() ? Blank::volume_within(box) : mesh_within(mesh_, box).volume; }
  bool overlaps() const override {
    std::call_once(asked_, [&] { overlaps_ = find_overlap(); });
    return overlaps_;
  }
  std::size_t bytes() const override { return mesh_blank_bytes(mesh_.triangle_count()); }
  void cross(int family, double u, double v, std::vector<LineRange>& ranges) const override;
  Vec3 normal(Vec3 at, int family, bool out) const override;
  std::vector<bool> bricks_at_surface(const Lattice& lattice) const override;

 private:
  Vec3 normal_of(std::size_t triangle, const Vec3& otherwise) const;
  const MeshIndex& index(int family) const;
  bool find_overlap() const;

  Mesh mesh_;
  Box3 box_;
  double volume_;
  // The index of the triangles for lines along each axis. It is built at the first use, because callers that need only the box and the
  // bricks need no index.
  mutable std::once_flag made_[3];
  mutable std::unique_ptr<const MeshIndex> along_[3];
  mutable std::once_flag asked_;
  mutable bool overlaps_ = false;
};

const MeshIndex& MeshBlank::index(int family) const {
  std::call_once(made_[family], [&] { along_[family] = std::make_unique<const MeshIndex>(mesh_, family); });
  return *along_[family];
}

/// Returns true if the intersection `a` comes before the intersection `b` along a line. Where two solid bodies touch, the intersection at
/// which the line enters the second body comes before the one at which it leaves the first body.
bool before(const MeshHit& a, const MeshHit& b) {
  if (a.place != b.place) return a.place < b.place;
  return a.turn != b.turn ? a.turn > b.turn : a.triangle < b.triangle;
}

/// Returns true if some interval of the line is inside two shells of the mesh at once.
bool winds_twice(std::vector<MeshHit>& hits) {
  std::sort(hits.begin(), hits.end(), before);
  int depth = 0;
  double since = 0;
  for (const MeshHit& hit : hits) {
    if (depth > 1 && hit.place - since > same_hit) return true;
    depth += hit.turn, since = hit.place;
  }
  return false;
}

/// Returns true if solid bodies of the mesh overlap. Finds overlaps that are at least about a hundredth of the blank's width; smaller
/// overlaps hardly change the volume.
bool MeshBlank::find_overlap() const {
  const double step_x = (box_.most.x - box_.least.x) / lines_to_overlap, step_y = (box_.most.y - box_.least.y) / lines_to_overlap;
  std::vector<MeshHit> hits;
  for (int i = 0; i < lines_to_overlap; ++i)
    for (int j = 0; j < lines_to_overlap; ++j) {
      hits.clear();
      index(2).hits(box_.least.x + (i + 0.5) * step_x, box_.least.y + (j + 0.5) * step_y, hits);
      if (winds_twice(hits)) return true;
    }
  return false;
}

void MeshBlank::cross(int family, double u, double v, std::vector<LineRange>& ranges) const {
  static thread_local std::vector<MeshHit> hits;
  hits.clear();
  index(family).hits(u, v, hits);
  take_ranges(hits.data(), hits.data() + hits.size(), ranges);
}

Vec3 MeshBlank::normal_of(std::size_t triangle, const Vec3& otherwise) const {
  const Vec3 a = mesh_.corner(triangle, 0), p = mesh_.corner(triangle, 1) - a, q = mesh_.corner(triangle, 2) - a;
  const Vec3 n{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  const double size = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
  return size > 0 ? (1 / size) * n : otherwise;
}

Vec3 MeshBlank::normal(Vec3 at, int family, bool out) const {
  static thread_local std::vector<MeshHit> hits;
  hits.clear();
  index(family).hits(along(at, (family + 1) % 3), along(at, (family + 2) % 3), hits);
  const MeshHit* best = nullptr;
  double nearest = same_hit;
  for (const MeshHit& hit : hits) {
    const double far = std::fabs(hit.place - along(at, family));
    if (hit.turn != (out ? -1 : 1) || far > nearest) continue;
    if (best != nullptr && far == nearest && best->triangle < hit.triangle) continue;
    best = &hit, nearest = far;
  }
  Vec3 square;
  along(square, family) = out ? 1 : -1;
  return best == nullptr ? square : normal_of(best->triangle, square);
}

/// Marks the bricks that the box around each triangle meets. A small margin covers the rounding of positions on lines.
std::vector<bool> MeshBlank::bricks_at_surface(const Lattice& lattice) const {
  std::vector<bool> at(lattice.size(), false);
  const double hair = 1e-3 * lattice.cell();
  for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
    const Vec3 a = mesh_.corner(t, 0), b = mesh_.corner(t, 1), c = mesh_.corner(t, 2);
    int low[3], high[3];
    for (int d = 0; d < 3; ++d) {
      const double least = std::min({along(a, d), along(b, d), along(c, d)}), most = std::max({along(a, d), along(b, d), along(c, d)});
      low[d] = std::max(lattice.first(d), int(std::floor((least - hair - along(lattice.origin(), d)) / lattice.edge())));
      high[d] = std::min(lattice.last(d), int(std::floor((most + hair - along(lattice.origin(), d)) / lattice.edge())));
    }
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int x = low[0]; x <= high[0]; ++x) at[lattice.at({x, y, z})] = true;
  }
  return at;
}

}  // namespace

void take_ranges(MeshHit* first, MeshHit* last, std::vector<LineRange>& ranges) {
  std::sort(first, last, before);
  int depth = 0;
  double from = 0;
  for (const MeshHit* hit = first; hit != last; ++hit) {
    const int next = depth + hit->turn;
    if (depth <= 0 && next > 0) from = hit->place;
    if (depth > 0 && next <= 0 && hit->place > from) ranges.push_back({from, hit->place});
    depth = next;
  }
}

std::shared_ptr<const Blank> mesh_blank(Mesh mesh) { return std::make_shared<MeshBlank>(std::move(mesh)); }

std::size_t mesh_blank_bytes(std::size_t triangles) {
  // 3 / 2 coordinates per triangle, because a closed mesh has half as many points as triangles.
  constexpr std::size_t mesh = 3 * sizeof(std::uint32_t) + 3 * sizeof(float) / 2;
  constexpr std::size_t index = 3 * (6 + 1) * sizeof(std::uint32_t);
  return triangles * (mesh + index);
}

}  // namespace kadr
