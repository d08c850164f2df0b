#pragma once
// Detects files of RS274/NGC that contain only subprograms. A file of this type is not run itself, so it needs no % or M2 at the end
// (spec/linuxcnc 1.1, 6.2).

#include "lang/text/line_reader.h"

namespace kadr {

/// True if the text contains at least one definition of an O subprogram, and apart from definitions only comments.
bool holds_only_subprograms(LineReader reader);

}  // namespace kadr
