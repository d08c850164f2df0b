// Cuts one brick with an upright tool: runs the class Cutter, compiled for the widest vectors that the processor has. Used by stock/stock.

#include "stock/cut/brick_cut.h"

#include "stock/cut/cutter_lanes.h"

namespace kadr {
namespace {

#if defined(__x86_64__) && defined(__GNUC__)
__attribute__((target("avx2"), flatten)) void cut_wide(Cutter& cutter) { cutter.cut<Wide>(); }
bool has_wide() { return __builtin_cpu_supports("avx2") != 0; }
#else
void cut_wide(Cutter& cutter) { cutter.cut<Pair>(); }
bool has_wide() { return false; }
#endif
__attribute__((flatten)) void cut_pair(Cutter& cutter) { cutter.cut<Pair>(); }

}  // namespace

BrickScale::BrickScale(double its_cell) : cell(float(its_cell)), edge(float(its_cell * brick_edge)) {
  for (int i = 0; i < brick_edge; ++i) place[i] = (float(i) + 0.5f) * cell;
}

LaneWidth widest_lanes() {
  static const LaneWidth width = has_wide() ? LaneWidth::wide : LaneWidth::pair;
  return width;
}

void cut_brick(Brick& brick, const BrickScale& scale, const LocalSweep& sweep, const SweptBody& body, std::int32_t by, CutOutcome& outcome,
               LaneWidth width) {
  Cutter cutter(brick, scale, sweep, body, by, outcome);
  if (cutter.stays_above()) return;
  if (cutter.takes_all()) return cutter.clear();
  width == LaneWidth::wide ? cut_wide(cutter) : cut_pair(cutter);
  cutter.end();
}

}  // namespace kadr
