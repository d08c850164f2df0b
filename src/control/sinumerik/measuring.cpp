// MEAS: a line at feed that ends where the probe touches (spec/sinumerik 17). Without a touch it ends at its end point, and $AC_MEA says
// so. Used by control/sinumerik.

#include <cmath>

#include "control/functions/probe_unstated.h"
#include "control/sinumerik/block_run.h"

namespace kadr::sinumerik {

Status BlockRun::measure(const NamedItem& item) {
  const auto value = number_of(item);
  if (!value) return fail(value.error());
  const double probe = std::fabs(*value);
  if (probe != 1 && probe != double{Measured::probes}) return fail(alarm(AlarmId::value_out_of_range, item.where, "MEAS", *value));
  if (m_.modal.radius_side != 0) return fail(alarm(AlarmId::compensation_active, item.where, "MEAS"));
  own_.words.probe = static_cast<int>(probe);
  own_.words.places["MEAS"] = item.where;
  return {};
}

Status Sinumerik::accept_answer(Emitter& m, const ProbeAnswer& answer) {
  m.needs_probe = false;
  for (std::size_t a = 0; a < m.axis_count; ++a) m.position.work[a] = answer.at[a];
  m.position.machine = m.frames.machine_of(m.position.work);
  m.position.programmed = m.transform.to_programmed(m.position.work);
  previous_ = m.position.work;
  Measured& measured = memory.measured;
  measured.touched[static_cast<std::size_t>(measured.probe - 1)] = made_contact(m, answer);
  measured.work = m.position.programmed;
  measured.machine = m.position.machine;
  return {};
}

}  // namespace kadr::sinumerik
