#pragma once
// The parameters of the features that only the NCT has: tools, waiting codes (spec/nct/12, 14.5).

#include "control/macro_b/variables/settings.h"

namespace kadr::nct {

struct Settings {
  int waiting_low = 0, waiting_high = 0;  // N2201, N2202: first and last waiting code
  bool life_counts_on_t = false;          // N2901 #1 TLC: T changes the tool and counts its use; false: M6 does both
  int offset_by_tool = 0;                 // N2923: the value of an H or D word that means the offset of the tool in the spindle
  int place_code = 0;                     // N2924: number of an M code; in a block with this M code, T is a pocket number
};

Settings read_settings(const macro_b::ParameterSource& source);

}  // namespace kadr::nct
