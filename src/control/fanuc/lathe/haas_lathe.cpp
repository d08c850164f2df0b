// What only the lathes of Haas have (spec/haas-st): drilling cycles on the side, the run-out of threads by M23 and M24.

#include "base/code_literals.h"
#include "control/block_context.h"
#include "control/fanuc/fanuc.h"
#include "control/fanuc/lathe/lathe.h"

namespace kadr::fanuc {

bool is_haas(const BlockContext& m) { return m.def.behaviour.lathe == Lathe::haas; }

bool drills_on_side(const CodeRow& row) { return row.tenth == 195_g || row.tenth == 196_g || (row.tenth >= 241_g && row.tenth <= 249_g); }

void note_run_out(Fanuc& fanuc, const CodeRow& row) {
  constexpr std::int32_t on = 230, off = 240;
  if (row.tenth == on || row.tenth == off) fanuc.state.turning.cuts_through = row.tenth == off;
}

}  // namespace kadr::fanuc
