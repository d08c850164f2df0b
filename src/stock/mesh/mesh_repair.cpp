// Closes a mesh, turns its triangles so that they face outwards, and reports faults of the mesh. Used by stock/mesh/mesh_file.

#include "stock/mesh/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

#include "stock/mesh/mesh_edges.h"
#include "stock/mesh/mesh_index.h"
#include "stock/mesh/point_weld.h"
#include "texts/mesh.h"

namespace kadr {
namespace {

std::string mm(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string at_point(const Vec3& p) { return "X" + mm(p.x) + " Y" + mm(p.y) + " Z" + mm(p.z); }

struct Repair {
  Mesh mesh;
  const MeshRules& rules;
  std::vector<std::uint32_t> numbers{};  // number that each triangle had in the file
  std::vector<std::string> notes{};
  MeshEdges edges{};  // faulty edges that remain after close()

  std::string bad_point_message() const;
  void close();
  void join_near();
  bool turn_to_fit();
  std::string open_mesh_message() const;
  std::vector<std::uint32_t> shells() const;
  void turn_shells();
  void turn(std::size_t triangle) { std::swap(mesh.triangles[3 * triangle + 1], mesh.triangles[3 * triangle + 2]); }
};

/// Returns a message about a corner with an invalid coordinate or point number, or at a position that is far beyond any machine; an empty
/// text if there is no such corner.
std::string Repair::bad_point_message() const {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t triangle = i / 3 + 1;
    if (mesh.triangles[i] >= mesh.point_count()) return translated(texts::mesh::no_such_point, triangle, mesh.triangles[i]);
    const Vec3 p = mesh.point(mesh.triangles[i]);
    for (const double v : {p.x, p.y, p.z}) {
      if (!std::isfinite(v)) return translated(texts::mesh::coordinate_no_number, triangle);
      if (std::fabs(v) > rules.reach) return translated(texts::mesh::beyond_any_machine, triangle, mm(v), mm(rules.reach));
    }
  }
  return {};
}

/// Turns the triangles of each shell so that they fit the first triangle of the shell: two neighbouring triangles must use their common
/// edge in opposite directions. Returns false if no orientation of the triangles fits.
bool Repair::turn_to_fit() {
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  const std::size_t count = mesh.triangle_count();
  // For each triangle its three neighbours, each as twice the number of the neighbour, plus 1 if both triangles use their common edge in
  // the same direction.
  std::vector<std::uint32_t> neighbours(3 * count), found(count, 0);
  for (std::size_t i = 0; i < uses.size(); i += 2) {
    if (i + 1 >= uses.size() || uses[i].ends != uses[i + 1].ends || (i + 2 < uses.size() && uses[i + 2].ends == uses[i].ends)) return false;
    const EdgeUse &a = uses[i], &b = uses[i + 1];
    const std::uint32_t same = a.upwards == b.upwards;
    neighbours[3 * std::size_t(a.triangle) + found[a.triangle]++] = 2 * b.triangle + same;
    neighbours[3 * std::size_t(b.triangle) + found[b.triangle]++] = 2 * a.triangle + same;
  }
  std::vector<std::uint8_t> turned(count, 2);  // 1: the triangle is turned; 0: not turned; 2: not yet decided
  std::vector<std::uint32_t> open;
  std::size_t turns = 0;
  for (std::size_t first = 0; first < count; ++first) {
    if (turned[first] != 2) continue;
    turned[first] = 0;
    open.push_back(std::uint32_t(first));
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = neighbours[3 * std::size_t(t) + k] / 2;
        const std::uint8_t orientation = turned[t] ^ std::uint8_t(neighbours[3 * std::size_t(t) + k] & 1);
        if (turned[other] == 2) turned[other] = orientation, open.push_back(other);
        // No orientation fits, because the surface has only one side, as a Möbius strip has.
        else if (turned[other] != orientation) return false;
      }
    }
  }
  for (std::size_t t = 0; t < count; ++t)
    if (turned[t] == 1) turn(t), ++turns;
  notes.push_back(counted(texts::mesh::triangles_turned, turns));
  return true;
}

/// Merges points within the tolerance, then turns triangles that have the wrong orientation. Each of these two repairs is made only if
/// edges are still open.
void Repair::close() {
  edges = edges_of(mesh);
  if (edges.open == 0) return;
  if (rules.weld > 0) join_near(), edges = edges_of(mesh);
  if (edges.open != 0 && turn_to_fit()) edges = edges_of(mesh);
}

/// Merges points of edges that belong to an odd number of triangles, because such edges are open.
void Repair::join_near() {
  std::vector<bool> marked(mesh.point_count(), false);
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    for (end = i; end < uses.size() && uses[end].ends == uses[i].ends;) ++end;
    if ((end - i) % 2 == 0) continue;
    marked[std::size_t(uses[i].ends >> 32)] = marked[std::size_t(uses[i].ends & 0xffffffffu)] = true;
  }
  if (const std::size_t joined = weld_near(mesh, marked, rules.weld); joined > 0) {
    notes.push_back(counted(texts::mesh::points_joined, joined, mm(rules.weld)));
    drop_flat(mesh, numbers);
  }
}

std::string Repair::open_mesh_message() const {
  if (mesh.triangles.empty()) return translated(texts::mesh::no_triangle);
  if (edges.open == 0) return {};
  return translated(texts::mesh::not_closed, edges.open, numbers[edges.open_triangle] + 1, at_point(mesh.corner(edges.open_triangle, 0)));
}

/// Returns for each triangle the lowest point number of the shell (connected surface) that contains the triangle.
std::vector<std::uint32_t> Repair::shells() const {
  std::vector<std::uint32_t> parent(mesh.point_count());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t a = root(mesh.triangles[i]), b = root(mesh.triangles[i / 3 * 3]);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> shell(mesh.triangle_count());
  for (std::size_t t = 0; t < shell.size(); ++t) shell[t] = root(mesh.triangles[3 * t]);
  return shell;
}

/// Turns shells that are inside out. A shell inside another shell is a cavity and remains inside out.
void Repair::turn_shells() {
  if (volume_of(mesh) < 0) {
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) turn(t);
    notes.push_back(translated(texts::mesh::inside_out));
  }
  const std::vector<std::uint32_t> shell = shells();
  std::vector<double> volume(mesh.point_count(), 0);
  std::vector<std::uint32_t> sample(mesh.point_count(), 0);
  for (std::size_t t = mesh.triangle_count(); t-- > 0;) {
    const Vec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    volume[shell[t]] += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    sample[shell[t]] = std::uint32_t(t);
  }
  if (std::none_of(volume.begin(), volume.end(), [](double v) { return v < 0; })) return;
  const MeshIndex upright(mesh, 2);
  std::vector<MeshHit> hits;
  std::vector<bool> turns(mesh.point_count(), false);
  std::size_t turned = 0;
  for (std::size_t s = 0; s < volume.size(); ++s) {
    if (volume[s] >= 0) continue;
    const Vec3 at = (1 / 3.0) * (mesh.corner(sample[s], 0) + mesh.corner(sample[s], 1) + mesh.corner(sample[s], 2));
    hits.clear();
    upright.hits(at.x, at.y, hits);
    int about = 0;
    for (const MeshHit& h : hits)
      if (h.place < at.z && shell[h.triangle] != s) about += h.turn;
    if (about <= 0) turns[s] = true, ++turned;
  }
  if (turned == 0) return;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    if (turns[shell[t]]) turn(t);
  notes.push_back(counted(texts::mesh::bodies_inside_out, turned));
}

}  // namespace

std::string too_many_message(std::size_t triangles, const MeshRules& rules) {
  if (triangles <= rules.memory / solid_bytes(1)) return {};
  return translated(texts::mesh::too_many_triangles, triangles, rules.memory / solid_bytes(1));
}

tl::expected<SolidMesh, std::string> solid_of(Mesh mesh, const MeshRules& rules) {
  if (std::string wrong = too_many_message(mesh.triangle_count(), rules); !wrong.empty()) return tl::unexpected(std::move(wrong));
  Repair repair{std::move(mesh), rules};
  if (std::string wrong = repair.bad_point_message(); !wrong.empty()) return tl::unexpected(std::move(wrong));
  drop_unused(repair.mesh);
  repair.numbers.resize(repair.mesh.triangle_count());
  std::iota(repair.numbers.begin(), repair.numbers.end(), 0u);
  weld_equal(repair.mesh);
  drop_flat(repair.mesh, repair.numbers);
  repair.close();
  drop_unused(repair.mesh);
  if (std::string wrong = repair.open_mesh_message(); !wrong.empty()) return tl::unexpected(std::move(wrong));
  repair.turn_shells();
  if (!(volume_of(repair.mesh) > 0)) return tl::unexpected(translated(texts::mesh::encloses_nothing));
  return SolidMesh{std::move(repair.mesh), std::move(repair.notes)};
}

}  // namespace kadr
