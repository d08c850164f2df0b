// Cuts with a tilted tool, with vectors that every processor has. Used by stock/cut/lean_cut.

#include "stock/cut/lean_ball_cutter.h"
#include "stock/cut/lean_cutter.h"
#include "stock/cut/lean_later.h"

namespace kadr {

void cut_leaning_pair(LeanCutter& cutter) { cutter.cut<Pair>(); }

}  // namespace kadr
