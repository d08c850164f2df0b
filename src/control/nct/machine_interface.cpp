// Input from the machine's logic and the operator that only the NCT accepts (spec/nct 12.3, 20.2).

#include <utility>

#include "control/emitter.h"
#include "control/nct/axes/coupling.h"
#include "control/nct/axes/drives.h"
#include "control/nct/nct.h"
#include "control/nct/waiting.h"

namespace kadr::nct {

void Nct::couple_axis(Emitter& m, const std::string& name, AxisLink link, bool on) {
  if (link == AxisLink::follows) nct::couple_axis(m, name, on);
  else request_axis(m, name, link, on);
}

void Nct::set_time(double at_ms, double cut_ms) {
  Fanuc::set_time(at_ms, cut_ms);
  constexpr double ms_per_s = 1000;
  const SpindleState& leading = spindle(Fanuc::state.main_spindle);
  const bool turns = leading.dir == SpindleDir::cw || leading.dir == SpindleDir::ccw;
  const bool turned_then = std::exchange(turned, turns);
  if (counts_time && (turns || turned_then)) tools.add_time(cut_ms / ms_per_s, spindle_magazine());
  counts_time = tools.counts_time();
}

bool Nct::waiting_suspended() const { return nct::waiting_suspended(*this); }

}  // namespace kadr::nct
