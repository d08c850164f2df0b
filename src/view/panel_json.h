#pragma once
// Converts what an operator sees to JSON of the page's protocol (docs/panel-protocol.md, The panel).

#include "panel/panel_machine.h"
#include "view/page_json.h"

namespace kadr {

/// The name in the protocol.
const char* name_of(PanelMode mode);
/// The state without the alarm and without who has control.
PageJson panel_json(const PanelState& state, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
