#pragma once
// Describes the keys of a set-up, as the page docs/setup.md or for a single control (kadr explain ID setup).

#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the description of all keys, with the controls that support each key. `controls`: the columns of the table, in order.
std::string setup_page(const std::vector<const ControlDef*>& controls, Lang lang);

/// Returns the description of the keys that this control supports.
std::string explain_setup(const ControlDef& def, Lang lang);

}  // namespace kadr
