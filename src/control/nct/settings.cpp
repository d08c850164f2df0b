// Reads the parameters of features that only the NCT has. Used by control/nct/nct.

#include "control/nct/settings.h"

namespace kadr::nct {

Settings read_settings(const macro_b::ParameterSource& source) {
  Settings s;
  s.waiting_low = macro_b::whole_parameter(source.value("2201", 0));
  s.waiting_high = macro_b::whole_parameter(source.value("2202", 0));
  s.life_counts_on_t = source.bit("2901", "1", 0);
  s.offset_by_tool = macro_b::whole_parameter(source.value("2923", 0));
  s.place_code = macro_b::whole_parameter(source.value("2924", 0));
  return s;
}

}  // namespace kadr::nct
