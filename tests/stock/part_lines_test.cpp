// stock/part/part_lines and points_inside: the same as mesh_blank() for each line, bit by bit.

#include "stock/part/part_lines.h"

#include <gtest/gtest.h>

#include <random>

#include "stock/blank/blank_window.h"
#include "stock/blank/mesh_blank.h"
#include "stock/brick/brick.h"
#include "stock/mesh/mesh_repair.h"
#include "stock/part/points_inside.h"
#include "stock/some_meshes.h"

namespace kadr::part_lines_test {
namespace {

using namespace test;

std::vector<Mesh> solids() {
  const Mesh box = box_mesh({-4, -4, -4}, {4, 4, 4});
  return {box, torus_mesh(20, 6, 2.5), solid_of(sphere_mesh(16, 5), {}).value().mesh,
          together(box, turned(box,
                               [](const Vec3& p) {
                                 return p + Vec3{8, 0.25, 0};
                               })),
          together(box_mesh({-6, -6, -6}, {6, 6, 6}), inside_out(box_mesh({-2, -2, -2}, {3, 3, 3})))};
}

void expect_same(const PartLines& lines, const Blank& body, const Lattice& lattice) {
  std::vector<LineRange> wanted;
  for (std::size_t b = 0; b < lattice.size(); ++b)
    for (int family = 0; family < 3; ++family)
      for (int line = 0; line < brick_lines; ++line) {
        wanted.clear();
        const Vec3 corner = lattice.corner(b);
        body.cross(family, along(corner, (family + 1) % 3) + (line % brick_edge + 0.5) * lattice.cell(),
                   along(corner, (family + 2) % 3) + (line / brick_edge + 0.5) * lattice.cell(), wanted);
        const auto found = lines.of(lattice.place(b), family, line);
        ASSERT_EQ(found.size(), wanted.size()) << family << ' ' << line;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
          ASSERT_EQ(found[i].from, wanted[i].from);
          ASSERT_EQ(found[i].to, wanted[i].to);
        }
      }
}

/// Lines through corners and edges, and a lattice smaller than the solid.
TEST(part_lines, are_those_of_the_body) {
  for (const Mesh& mesh : solids())
    for (const double cell : {1.0, 0.5, 0.3}) {
      expect_same(PartLines(mesh, Lattice(box_of(mesh), cell), std::nullopt, 2), *mesh_blank(mesh), Lattice(box_of(mesh), cell));
      const Lattice within({{-1, -2, -3}, {3, 2, 1}}, cell);
      expect_same(PartLines(mesh, within, std::nullopt, 1), *mesh_blank(mesh), within);
    }
}

TEST(part_lines, end_at_a_window) {
  const Box3 window{{-3, -2.5, -4.5}, {2, 3.5, 1}};
  for (const Mesh& mesh : solids()) {
    const auto body = blank_within(mesh_blank(mesh), window);
    const Lattice lattice(window, 0.5);
    expect_same(PartLines(mesh, lattice, body->box(), 3), *body, lattice);
  }
}

TEST(points_inside, are_those_that_the_body_holds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-8, 8);
  for (const Mesh& mesh : solids()) {
    std::vector<float> points = mesh.points;  // corners, where hits are at the height of the point itself
    for (int i = 0; i < 6000; ++i) points.push_back(i % 4 == 0 ? float(int(any(random))) : any(random));
    const std::vector<std::uint8_t> one = points_inside(mesh, points, 1);
    EXPECT_EQ(one, points_inside(mesh, points, 3));
    const auto body = mesh_blank(mesh);
    std::vector<LineRange> ranges;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
      const double x = double(points[3 * i]), y = double(points[3 * i + 1]), z = double(points[3 * i + 2]);
      ranges.clear();
      body->cross(2, x, y, ranges);
      bool holds = false;
      for (const LineRange& r : ranges) holds = holds || (r.from < z && z < r.to);
      ASSERT_EQ(one[i] != 0, holds) << x << ' ' << y << ' ' << z;
      inside += holds;
    }
    EXPECT_GT(inside, 20U);
  }
}

/// All points at one position in the plane, or on one line.
TEST(points_inside, of_points_in_a_row) {
  const Mesh box = box_mesh({-4, -4, -4}, {4, 4, 4});
  EXPECT_EQ(points_inside(box, {1, 1, 0, 1, 1, 4, 1, 1, 5}, 2), (std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_EQ(points_inside(box, {1, -9, 0, 1, 1, 3, 1, 9, 0}, 2), (std::vector<std::uint8_t>{0, 1, 0}));
  EXPECT_TRUE(points_inside(box, {}, 2).empty());
}

}  // namespace
}  // namespace kadr::part_lines_test
