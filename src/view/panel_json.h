#pragma once
// What an operator sees → JSON of the page's protocol (docs/panel-protocol.md, The panel).

#include "panel/panel_machine.h"
#include "view/page_json.h"

namespace kadr {

/// A name of the protocol.
const char* name_of(PanelMode mode);
/// But for the alarm and who holds the controls.
PageJson panel_json(const PanelState& state, const std::vector<std::string>& axes, Lang lang);

}  // namespace kadr
