#pragma once
// The names of a conversational block (spec/heidenhain 2.4, 9, 10): labels, programs, tools, Q parameters. Used by
// view/structure/line_names.

#include <string_view>
#include <vector>

#include "view/structure/line_names.h"

namespace kadr {

/// Adds the names of one line.
void add_klartext_names(std::string_view line, std::vector<NamedPlace>& names);

}  // namespace kadr
