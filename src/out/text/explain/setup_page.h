#pragma once
// Describes the keys of a set-up: the page docs/setup.md, and the keys that one control supports (kadr explain ID setup).

#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the description of all keys, with the controls that support each. `controls` are the columns of the table, in order.
std::string setup_page(const std::vector<const ControlDef*>& controls, Lang lang);

/// Returns the keys that this control supports.
std::string explain_setup(const ControlDef& def, Lang lang);

}  // namespace kadr
