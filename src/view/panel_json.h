#pragma once
// Converts the state of an operator panel to JSON of the page's protocol (docs/panel-protocol.md, The panel).

#include "panel/panel_machine.h"
#include "view/page/page_json.h"

namespace kadr {

/// Returns the name that a mode has in the protocol.
const char* name_of(PanelMode mode);
/// Converts the state to JSON. The alarm, and the number of the page that has control, are not part of the result.
PageJson panel_json(const PanelState& state, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
