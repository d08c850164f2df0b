#pragma once
// Detects subprogram files of RS274/NGC: they are not run themselves, and so need no % or M2 at the end (spec/linuxcnc 1.1, 6.2).

#include "lang/text/line_reader.h"

namespace kadr {

/// True if the text consists only of definitions of O subprograms, at least one, and remarks.
bool holds_only_subprograms(LineReader reader);

}  // namespace kadr
