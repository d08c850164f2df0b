#pragma once
// Detects files of RS274/NGC that contain only subprograms. Such a file is not run itself, so it needs no % or M2 at the end
// (spec/linuxcnc 1.1, 6.2).

#include "lang/text/line_reader.h"

namespace kadr {

/// True if the text contains at least one definition of an O subprogram, and otherwise only remarks.
bool holds_only_subprograms(LineReader reader);

}  // namespace kadr
