// Measures NearestTriangle: looks up a million points on or near the surface of a ball-milled block. `kadr cut --part` does this for each
// point of the surface that it has cut.
//
//   build/bench/bench/kadr_bench --benchmark_filter=Nearest

#include <benchmark/benchmark.h>

#include <cmath>

#include "stock/part/nearest_triangle.h"

namespace {

using namespace kadr;

constexpr std::uint32_t points_along = 695;  // points along each side of the mesh: 964,664 triangles
constexpr std::size_t questions = 1'000'000;
constexpr double off = 0.01;  // distance of the points from the surface, mm, up or down

/// Returns the mesh of parallel ball-milled grooves on 100 × 100 mm.
Mesh milled() {
  Mesh mesh;
  const double step = 100.0 / (points_along - 1);
  for (std::uint32_t j = 0; j < points_along; ++j)
    for (std::uint32_t i = 0; i < points_along; ++i) {
      const double x = i * step, y = j * step, groove = std::remainder(y, 0.5);
      mesh.points.insert(mesh.points.end(), {float(x), float(y), float(-8 + 4 * std::sin(x / 9) * std::cos(y / 13) + groove * groove / 6)});
    }
  for (std::uint32_t j = 0; j + 1 < points_along; ++j)
    for (std::uint32_t i = 0; i + 1 < points_along; ++i) {
      const std::uint32_t a = j * points_along + i, b = a + 1, c = a + points_along, d = c + 1;
      mesh.triangles.insert(mesh.triangles.end(), {a, b, d, a, d, c});
    }
  return mesh;
}

void NearestTriangleBuilds(benchmark::State& state) {
  const Mesh mesh = milled();
  for (auto _ : state) benchmark::DoNotOptimize(NearestTriangle(mesh));
}

void NearestTriangleMillionPoints(benchmark::State& state) {
  const Mesh mesh = milled();
  const NearestTriangle nearest(mesh);
  for (auto _ : state) {
    std::uint32_t hint = 0;
    double sum = 0;
    for (std::size_t i = 0; i < questions; ++i) {
      Vec3 at = mesh.corner(i % mesh.triangle_count(), i % 3);
      at.z += i % 2 == 0 ? off : -off;
      sum += nearest.distance(at, hint);
    }
    benchmark::DoNotOptimize(sum);
  }
}

BENCHMARK(NearestTriangleBuilds)->Unit(benchmark::kMillisecond);
BENCHMARK(NearestTriangleMillionPoints)->Unit(benchmark::kMillisecond);

}  // namespace
