// G22, G23: safety zones that the program sets (spec/nct/22 22.2). The machine checks motions against the zones.

#include <limits>

#include "control/fanuc/fanuc.h"
#include "control/fanuc/words/coordinates.h"
#include "control/functions/functions.h"

namespace kadr::functions {

/// G22 X Y Z I J K P: sets the limits of the zone in machine coordinates. INFERRED: a missing word means no limit; without P the inside is
/// forbidden; for an axis in diameter programming the limits are diameters too.
Status work_area_on(Emitter& m, const Call& call) {
  constexpr double none = std::numeric_limits<double>::infinity();
  constexpr char max_letters[] = {'X', 'Y', 'Z'}, least_letters[] = {'I', 'J', 'K'};
  if (m.block->letters == 0) return {};  // G22 at power-on has no words (3.4), so there are no limits yet
  ZoneChange zone{true, false, 0, {}, {}};
  for (int role = 1; role <= 3; ++role) {
    const char most = max_letters[role - 1], least = least_letters[role - 1];
    if (!m.has(most) && !m.has(least)) continue;
    const int main = fanuc::main_axis(m, role);
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
  m.each_block = true;  // from now on the machine may refuse a motion, so run() returns the actions of each block separately
  macro_b_of(m).stops_reading = true;
  return {};
}

/// G23: restores the zone that the parameters describe. Values that were written into the parameters take effect with G23 (22.2).
Status work_area_off(Emitter& m, const Call&) {
  const macro_b::ParameterStore& p = macro_b_of(m).parameters;
  const auto enabled = p.named("1000"), control = p.named("1001"), most = p.named("1006"), least = p.named("1007");
  constexpr int takes_part = 1, outside = 0, limits = 1, before = 2;
  ZoneChange zone{p.bit(control, limits), p.bit(control, outside), 0, {}, {}, true};
  for (std::size_t a = 0; a < m.axis_count; ++a) {
    const int number = m.def.axis_numbers[a];
    if (p.bit(enabled, takes_part, number)) zone.axes |= AxisMask{1} << a;
    zone.most[a] = p.value(most, number);
    zone.least[a] = p.value(least, number);
  }
  // no axis takes part, so the parameters describe no zone, and an empty zone is emitted
  if (zone.axes == 0) zone = {false, false, 1, {}, {}, true};
  m.emit(zone);
  m.emit(ZoneChange{p.bit(control, before), false, 0, {}, {}, true});
  // from now on the machine may refuse a motion, so run() returns the actions of each block separately
  if (zone.on) m.each_block = true;
  macro_b_of(m).stops_reading = true;
  return {};
}

}  // namespace kadr::functions
