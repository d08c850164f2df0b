#pragma once
// Describes the keys of a set-up, as the page docs/setup.md or for a single control (kadr explain ID setup).

#include <string>

#include "config/alarm_texts.h"
#include "config/control/control_def.h"

namespace kadr {

/// Returns the description of all keys as the rows of a Markdown table. `controls`: the controls that the page covers; the row of a key
/// states which of them support the key.
std::string setup_page(const std::vector<const ControlDef*>& controls, Lang lang);

/// Returns the description of the keys that this control supports.
std::string explain_setup(const ControlDef& def, Lang lang);

}  // namespace kadr
