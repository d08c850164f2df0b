// Measures the comparison of `kadr cut --part` after the part is cut: a million points of a ball-milled surface, and the material below
// it, are compared with a target part of a million triangles.
//
//   build/bench/bench/kadr_bench --benchmark_filter=Part

#include <benchmark/benchmark.h>

#include <cmath>

#include "stock/blank/mesh_blank.h"
#include "stock/part/part_compare.h"

namespace {

using namespace kadr;

constexpr double side = 100;                            // mm
constexpr double part_cell = 0.25, finer_cell = 0.167;  // mm: give 482,000 points with two triangles each, and a million points
constexpr double step = 0.5, off = 0.004;               // mm: distance between rows; height of the cut surface above the target part

double height(double x, double y) { return -8 + 4 * std::sin(x / 9) * std::cos(y / 13); }

Stock milled(double cell, double above, int threads) {
  Stock stock(box_blank({{0, 0, -20}, {side, side, 0}}), cell, threads);
  ToolGeometry ball;
  ball.kind = ToolKind::ball, ball.diameter = 6, ball.flutes = 22, ball.length = 50;
  const std::uint16_t tool = stock.add_tool(shape_of(ball));
  for (double y = 0; y <= side; y += step)
    for (double x = 0; x < side; x += step) stock.add({{x, y, height(x, y) + above}, {x + step, y, height(x + step, y) + above}, tool});
  (void)stock.cut();
  return stock;
}

void PartComparisonMillionPoints(benchmark::State& state) {
  const int threads = int(state.range(0));
  const Mesh part = surface_of(milled(part_cell, 0, threads));
  const Stock stock = milled(finer_cell, off, threads);
  const Surface surface = surface_of(stock);
  for (auto _ : state) benchmark::DoNotOptimize(compare(stock, surface, part));
  state.counters["points"] = double(surface.point_count());
  state.counters["triangles"] = double(part.triangle_count());
}

BENCHMARK(PartComparisonMillionPoints)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
