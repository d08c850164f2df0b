#pragma once
// Files of subprograms of RS274/NGC: nobody runs them, so that they end without a sign % or M2 (spec/linuxcnc 1.1, 6.2).

#include "lang/text/line_reader.h"

namespace kadr {

/// The text is definitions of O subprograms, remarks, and nothing else; at least one.
bool holds_only_subprograms(LineReader reader);

}  // namespace kadr
