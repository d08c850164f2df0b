// stock/surface/sheets: for any distribution of material the surface is a closed manifold.

#include "stock/surface/sheets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>

#include "stock/mesh/mesh_edges.h"
#include "stock/some_tools.h"
#include "stock/surface/surface.h"

namespace kadr::sheets_test {
namespace {

/// Cubes of 1 mm, some of them material.
class Cubes : public Blank {
 public:
  Cubes(int edge, std::vector<bool> filled) : edge_(edge), filled_(std::move(filled)) {}
  Box3 box() const override { return {{0, 0, 0}, {double(edge_), double(edge_), double(edge_)}}; }
  void cross(int family, double u, double v, std::vector<LineRange>& ranges) const override {
    for (int w = 0; w < edge_; ++w) {
      int p[3];
      p[family] = w, p[(family + 1) % 3] = int(std::floor(u)), p[(family + 2) % 3] = int(std::floor(v));
      if (!at(p[0], p[1], p[2])) continue;
      if (!ranges.empty() && ranges.back().to == w) ranges.back().to = w + 1;
      else ranges.push_back({double(w), double(w + 1)});
    }
  }
  Vec3 normal(Vec3, int family, bool out) const override {
    Vec3 n;
    along(n, family) = out ? 1 : -1;
    return n;
  }
  double volume() const override { return double(std::count(filled_.begin(), filled_.end(), true)); }

 private:
  bool at(int x, int y, int z) const {
    const bool within = x >= 0 && y >= 0 && z >= 0 && x < edge_ && y < edge_ && z < edge_;
    return within && filled_[std::size_t((z * edge_ + y) * edge_ + x)];
  }
  int edge_;
  std::vector<bool> filled_;
};

TEST(sheets, every_crossed_edge_has_one) {
  for (unsigned corners = 0; corners < 256; ++corners) {
    const Sheets& s = plain_sheets(corners);
    int crossed = 0;
    for (const std::uint8_t sheet : s.of_edge) crossed += sheet != no_sheet;
    EXPECT_EQ(crossed == 0, corners == 0 || corners == 255);
    EXPECT_LE(s.count, 4);
    EXPECT_LE(std::popcount(unsigned(s.doubled)), 1) << corners;
    if (s.doubled != 0) {
      EXPECT_EQ(sheets_of(corners, s.doubled).doubled, 0) << corners;
    }
  }
}

RC_GTEST_PROP(sheets, surfaces_of_any_signs_are_closed_manifolds, (unsigned seed)) {
  constexpr int edge = 19;  // reaches across the borders of bricks
  Chance chance(seed);
  const int share = 1 + chance.below(9);
  std::vector<bool> filled(edge * edge * edge);
  for (std::size_t i = 0; i < filled.size(); ++i) filled[i] = chance.below(10) < share;
  const auto cubes = std::make_shared<Cubes>(edge, filled);
  const Surface surface = surface_of(Stock(cubes, 1, 2));
  const MeshEdges edges = edges_of(surface);
  RC_ASSERT(edges.open == 0U);
  RC_ASSERT(edges.doubled == 0U);
  RC_ASSERT(surface.triangle_count() > 0U);
}

}  // namespace
}  // namespace kadr::sheets_test
