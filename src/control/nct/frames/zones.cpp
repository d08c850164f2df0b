// G22, G23: the working area by the program (spec/nct/22 22.2). What is forbidden the machine watches.

#include <limits>

#include "control/functions/functions.h"
#include "control/nct/nct.h"
#include "control/nct/words/coordinates.h"

namespace kadr::functions {

/// G22 X Y Z I J K P: limits in machine coordinates. INFERRED: a limit left out is none; without P inside is forbidden; an axis
/// in diameter programming has diameters here too.
Status work_area_on(Interpreter& m, const Call& call) {
  constexpr double none = std::numeric_limits<double>::infinity();
  constexpr char most_letters[] = {'X', 'Y', 'Z'}, least_letters[] = {'I', 'J', 'K'};
  if (m.block->letters == 0) return {};  // power-on (3.4): no limits yet
  ZoneChange zone{true, false, 0, {}, {}};
  for (int role = 1; role <= 3; ++role) {
    const char most = most_letters[role - 1], least = least_letters[role - 1];
    if (!m.has(most) && !m.has(least)) continue;
    const int main = nct::main_axis(m, role);
    if (main < 0) return fail(alarm(AlarmId::illegal_address, m.where(m.has(most) ? most : least), m.has(most) ? most : least));
    const auto a = static_cast<std::size_t>(main);
    const double part = (m.modal.diameter >> a & 1u) != 0 ? 0.5 : 1;
    if (const Word* const w = m.word(most); w != nullptr && w->incremental)
      return fail(alarm(AlarmId::increment_not_allowed, w->where, w->written));
    zone.axes |= 1u << a;
    zone.most[a] = m.has(most) ? part * m.length_value(most) : none;
    zone.least[a] = m.has(least) ? part * m.length_value(least) : -none;
    if (zone.most[a] < zone.least[a]) return fail(alarm(AlarmId::value_out_of_range, m.where(most), most, m.value(most)));
  }
  if (zone.axes == 0) return fail(alarm(AlarmId::word_missing, call.where, 'X', call.row->code));
  const auto p = m.whole('P', 0, 1);
  if (!p) return fail(p.error());
  zone.outside_forbidden = *p == 1;
  m.emit(zone);
  m.each_block = true;  // from here on the machine may refuse a motion
  nct_of(m).stops_reading = true;
  return {};
}

/// G23: the zone of the parameters again.
Status work_area_off(Interpreter& m, const Call&) {
  m.emit(ZoneChange{});
  nct_of(m).stops_reading = true;
  return {};
}

}  // namespace kadr::functions
