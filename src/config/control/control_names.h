#pragma once
// The names of statements, words and cycles of a control whose blocks have names: sections [names] and [cycle_parameters] of its file. They
// are for people only: kadr explain, the pages of docs/controls, the hover of the web page. The engine does not read them.

#include <string>
#include <string_view>
#include <vector>

#include "config/control/control_def.h"

namespace kadr {

struct NameParameter {
  std::string name;  // as the manual names it: "RTP"
  Text text;
};

struct NameRow {
  std::string name;  // in upper case: "CYCLE83", "TRANS"
  Text text;
  std::string manual;
  bool works = true;                      // false: Kadr refuses the name
  std::vector<NameParameter> parameters;  // of a call, in their order; empty: the name has none
};

/// Returns the names of the control, or of the built-in control that it extends, in the order of the file. They are read once. Empty for a
/// control whose blocks have no names.
const std::vector<NameRow>& named_rows(const ControlDef& def);

/// Returns the row of a name, in any letter case; nullptr if there is none.
const NameRow* named_row(const ControlDef& def, std::string_view name);

}  // namespace kadr
