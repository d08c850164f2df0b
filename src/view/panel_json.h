#pragma once
// Converts the state of an operator panel to JSON for the page (docs/panel-protocol.md, The panel).

#include "panel/panel_machine.h"
#include "view/page/page_json.h"

namespace kadr {

/// Returns the name of a mode in the protocol.
const char* name_of(PanelMode mode);
/// Converts the state of a panel to JSON. `opened`: the program of the machine. The caller must add the alarm, and the number of the page
/// that has control.
PageJson panel_json(const PanelState& state, const std::vector<std::string>& axes, const OpenedProgram& opened, Lang lang);

}  // namespace kadr
