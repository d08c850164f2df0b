// Measures the compensated motions per second of the cutter compensation stage alone, on a contour of lines and tangent arcs like that of
// the load program comp_200k.

#include <benchmark/benchmark.h>

#include <vector>

#include "path/compensation/radius_compensation.h"

namespace kadr {
namespace {

constexpr int motions = 100'000;
constexpr std::size_t batch_size = 256;

Motion motion(MotionKind kind, Vec2 to, Vec2 center = {}, double turns = 0) {
  Motion m;
  m.kind = kind;
  m.to[0] = m.machine[0] = to.x;
  m.to[1] = m.machine[1] = to.y;
  m.center = center;
  m.turns = turns;
  m.named = 3;
  m.feed = 1000;
  m.side = 1;
  m.tool_radius = 5;
  return m;
}

/// Returns a contour: right, a quarter circle to the left, up, a quarter circle to the right, all tangential. With `corners` chords
/// replace the arcs.
/// become chords.
std::vector<Motion> contour(bool corners) {
  std::vector<Motion> all{motion(MotionKind::feed, {20, 0})};
  all.back().side_step = SideStep::begins;
  const auto arc = [&](MotionKind kind, Vec2 to, Vec2 center) {
    all.push_back(corners ? motion(MotionKind::feed, to) : motion(kind, to, center, 0.25));
  };
  for (Vec2 at{20, 0}; all.size() < motions; at = at + Vec2{26, 26}) {
    all.push_back(motion(MotionKind::feed, at + Vec2{10, 0}));
    arc(MotionKind::arc_ccw, at + Vec2{18, 8}, at + Vec2{10, 8});
    all.push_back(motion(MotionKind::feed, at + Vec2{18, 18}));
    arc(MotionKind::arc_cw, at + Vec2{26, 26}, at + Vec2{26, 18});
  }
  return all;
}

void compensate(benchmark::State& state) {
  const std::vector<Motion> all = contour(state.range(0) != 0);
  CompensationCheck check;
  check.interference = state.range(1) != 0;
  ActionBatch batch;
  for (auto _ : state) {
    RadiusCompensation compensation{ToolPosition{}};
    batch.clear();
    batch.add().what = check;
    for (std::size_t i = 0; i < all.size(); ++i) {
      batch.add().what = all[i];
      if (batch.size() < batch_size && i + 1 < all.size()) continue;
      if (compensation.take(batch, i + 1 == all.size())) state.SkipWithError("an alarm");
      benchmark::DoNotOptimize(batch.begin());
      batch.clear();
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
}
BENCHMARK(compensate)->ArgNames({"corners", "check"})->ArgsProduct({{0, 1}, {0, 1}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kadr
