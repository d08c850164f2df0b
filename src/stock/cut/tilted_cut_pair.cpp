// Cuts with a tilted tool, with pairs of 16-byte vectors, which every processor supports. Used by stock/cut/tilted_cut.

#include "stock/cut/tilted_ball_cutter.h"
#include "stock/cut/tilted_cutter.h"
#include "stock/cut/tilted_later.h"

namespace kadr {

void cut_tilted_pair(TiltedCutter& cutter) { cutter.cut<Pair>(); }

}  // namespace kadr
