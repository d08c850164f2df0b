#pragma once
// Explains names of statements, words and cycles, for controls whose blocks have names: `kadr explain sinumerik CYCLE83`.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/span.h"
#include "config/control/control_names.h"
#include "config/texts.h"

namespace kadr {

/// Returns the call and the meaning of a name, with one line for each parameter: its position, its name and its meaning. Returns nullopt if
/// the control has no row for the name.
std::optional<std::string> explain_name(const ControlDef& def, std::string_view name, Lang lang);

/// A name, a code or an address in a statement.
struct StatementPart {
  Span where;
  std::string code;  // "CYCLE83", "G1", "X"
  const NameRow* name = nullptr;
  const NameParameter* parameter = nullptr;  // an argument of a call of `name`
};

/// Finds the parts of a statement in the line, outside texts in quotation marks. Arguments of a cycle follow the cycle's name.
void each_part(const ControlDef& def, std::string_view line, Span statement, const std::function<void(const StatementPart&)>& take);

/// Appends the tables of names and of parameters to the page docs/controls/ID.md.
void name_rows(const ControlDef& def, std::string& page);

}  // namespace kadr
