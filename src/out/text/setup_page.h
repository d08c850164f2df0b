#pragma once
// The keys of a set-up for people: the page docs/setup.md, and what one control knows of them (kadr explain ID setup).

#include <string>

#include "config/alarm_texts.h"
#include "config/control_def.h"

namespace kadr {

/// All keys, and which control knows them. `controls`: in the order of the columns.
std::string setup_page(const std::vector<const ControlDef*>& controls, Lang lang);

/// The keys that this control knows.
std::string explain_setup(const ControlDef& def, Lang lang);

}  // namespace kadr
