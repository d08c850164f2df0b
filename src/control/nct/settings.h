#pragma once
// The parameters of the features that only the NCT has: tools, waiting codes (spec/nct/12, 14.5).

#include "control/macro_b/variables/settings.h"

namespace kadr::nct {

struct Settings {
  int waiting_low = 0, waiting_high = 0;  // N2201, N2202: first and last waiting code
  bool life_counts_on_t = false;          // N2901 #1 TLC: T, not M6, changes the tool and counts its use
  int offset_by_tool = 0;                 // N2923: the H or D number that means the offset of the tool in the spindle
  int place_code = 0;                     // N2924: M code that makes T of its block a pocket number
};

Settings read_settings(const macro_b::ParameterSource& source);

}  // namespace kadr::nct
